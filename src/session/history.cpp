#include "session/history.hpp"

#include <algorithm>

namespace steplab {

namespace {

/// Moments kept at most, so that thinning out stays a matter of microseconds.
constexpr std::size_t most_moments = 4096;

}  // namespace

void History::offer(const Simulation& simulation) {
    const bool new_segment = moments_.empty() || moments_.back().segment() != simulation.segment();
    if (!new_segment && simulation.step() < moments_.back().step() + spacing_) return;
    moments_.push_back(simulation.save());
    used_ += moments_.back().bytes();
    if (used_ > allowed_ || moments_.size() > most_moments) thin_out();
    while (used_ > allowed_ && moments_.size() > 2) drop_oldest();
}

/// Doubles the spacing and keeps every other moment, the first of each segment always.
void History::thin_out() {
    spacing_ *= 2;
    std::vector<Simulation::Snapshot> kept;
    for (const auto& moment : moments_) {
        const bool begins_segment = kept.empty() || kept.back().segment() != moment.segment();
        if (begins_segment || moment.step() >= kept.back().step() + spacing_ || &moment == &moments_.back()) {
            kept.push_back(moment);
        }
    }
    moments_ = std::move(kept);
    used_ = 0;
    for (const auto& moment : moments_) used_ += moment.bytes();
}

void History::drop_oldest() {
    used_ -= moments_.front().bytes();
    moments_.erase(moments_.begin());
}

bool History::reaches_before(std::uint64_t step) const { return !moments_.empty() && moments_.front().step() < step; }

void History::go_back(Simulation& simulation, std::uint64_t step) {
    const auto after =
        std::find_if(moments_.begin(), moments_.end(), [&](const auto& moment) { return moment.step() > step; });
    if (after == moments_.begin()) return;
    for (auto moment = after; moment != moments_.end(); ++moment) used_ -= moment->bytes();
    moments_.erase(after, moments_.end());
    simulation.restore(moments_.back());
    simulation.advance(step - simulation.step());
}

void History::clear() {
    moments_.clear();
    used_ = 0;
    spacing_ = 16;
}

}  // namespace steplab
