#include "lab/limits/replayed_run.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace steplab {

namespace {

/// A way of so many steps is long: moments are kept at the ends of its parts, as far as this memory holds them.
constexpr std::uint64_t long_way = 4096, parts_of_long_way = 64;
constexpr std::size_t most_kept_bytes = std::size_t{64} << 20;

}  // namespace

ReplayedRun::ReplayedRun(std::span<const SegmentBegin> changes, std::vector<Moment> kept)
    : run_(changes.front().description), changes_(changes.begin(), changes.end()), kept_{moment()} {
    std::move(kept.begin(), kept.end(), std::back_inserter(kept_));
}

void ReplayedRun::advance_by(std::uint64_t steps) {
    run_.advance(steps);
    steps_ += steps;
}

void ReplayedRun::advance_to(std::uint64_t step) {
    while (!run_.divergence()) {
        const bool changes = taken_ < changes_.size() && changes_[taken_].step <= step;
        const std::uint64_t target = changes ? changes_[taken_].step : step;
        if (run_.step() < target) advance_by(target - run_.step());
        if (!changes || run_.divergence()) return;
        const SegmentBegin& change = changes_[taken_++];
        change.act ? run_.act(*change.act) : static_cast<void>(run_.change(change.description));
    }
}

void ReplayedRun::go_to(std::uint64_t step) {
    const auto after =
        std::find_if(kept_.begin(), kept_.end(), [&](const Moment& kept) { return kept.snapshot.step() > step; });
    const Moment& nearest = *std::prev(after);
    if (run_.step() > step || nearest.snapshot.step() > run_.step()) go_back_to(nearest);
    const bool keeps = after == kept_.end() && step - run_.step() >= long_way;
    const std::uint64_t first = run_.step(), way = step - first;
    for (std::uint64_t part = 1; keeps && part < parts_of_long_way && !run_.divergence(); ++part) {
        advance_to(first + way * part / parts_of_long_way);
        if (kept_.size() * kept_.front().snapshot.bytes() < most_kept_bytes && run_.is_plausible())
            kept_.push_back(moment());
    }
    advance_to(step);
}

void ReplayedRun::go_back_to(const Moment& moment) {
    run_.restore(moment.snapshot);
    taken_ = moment.taken;
}

}  // namespace steplab
