#include "lab/limits/replayed_run.hpp"

#include <algorithm>

namespace steplab {

ReplayedRun::ReplayedRun(std::span<const SegmentBegin> changes)
    : run_(changes.front().description), changes_(changes.begin(), changes.end()) {}

void ReplayedRun::advance_to(std::uint64_t step) {
    while (!run_.divergence()) {
        const bool changes = taken_ < changes_.size() && changes_[taken_].step <= step;
        const std::uint64_t target = changes ? changes_[taken_].step : step;
        if (run_.step() < target) run_.advance(target - run_.step());
        if (!changes || run_.divergence()) return;
        const SegmentBegin& change = changes_[taken_++];
        change.act ? run_.act(*change.act) : static_cast<void>(run_.change(change.description));
    }
}

void ReplayedRun::go_back_to(const Moment& moment) {
    run_.restore(moment.snapshot);
    taken_ = moment.taken;
}

}  // namespace steplab
