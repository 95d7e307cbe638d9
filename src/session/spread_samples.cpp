#include "session/spread_samples.hpp"

#include "session/same_way.hpp"

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

/// Of those runs in which the particle is somewhere.
std::optional<SpreadSample::Reach> reach_of(const Frame& frame, std::size_t particle, Vec3 rest) {
    std::optional<SpreadSample::Reach> reach;
    for (std::size_t i = particle; i < frame.ensemble.size(); i += frame.positions.size()) {
        const Vec3 at = frame.ensemble[i] - rest;
        if (!std::isfinite(at.x + at.y + at.z)) continue;
        if (!reach) reach = {at, at};
        auto& [low, high] = *reach;
        low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
    return reach;
}

}  // namespace

void SpreadSamples::follow(std::optional<std::size_t> particle) {
    if (particle == particle_) return;
    particle_ = particle;
    rows_.edit([](SpreadSample& sample) { sample.reach.reset(); });
}

void SpreadSamples::follow(std::span<const SegmentBegin> changes) {
    const auto other = first_difference(changes_, changes);
    if (!other) return;
    changes_.assign(changes.begin(), changes.end());
    rows_.cut(*other);
}

void SpreadSamples::offer(const Simulation& run, LiveEnsemble& ensemble) {
    if (!rows_.belongs(run.step())) return;
    const bool followed = particle_ && *particle_ < run.particles();
    const SpreadSample* const known = rows_.at(run.step());
    if (known && (known->reach || !followed)) return;
    run.frame(frame_);
    SpreadSample sample{run.step(), run.time(), ensemble.observe(frame_).largest};
    if (followed) sample.reach = reach_of(frame_, *particle_, run.shape()->rest[*particle_]);
    rows_.put(sample);
}

}  // namespace steplab
