#pragma once

#include "core/frame.hpp"
#include "core/vec3.hpp"
#include "session/step_samples.hpp"
#include "sim/ensemble/live_ensemble.hpp"
#include "sim/run/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace steplab {

/// How far the runs of an ensemble are apart at one step of the run that they go beside.
struct SpreadSample {
    std::uint64_t step = 0;
    double time = 0;     ///< [s]
    double largest = 0;  ///< largest distance of a particle from where it is in the run [m]
    /// Smallest and largest displacement of the followed particle along each axis [m]; none without one.
    struct Reach {
        Vec3 low, high;
    };
    std::optional<Reach> reach = {};
};
using SpreadSeries = SampleSeriesOf<SpreadSample>;

/// The spread of an ensemble at the steps of a grid, taken on the way.
class SpreadSamples {
public:
    /// Of so many particles in all runs.
    explicit SpreadSamples(std::size_t particles) : rows_(first_spacing(particles)) {}

    /// Steps from here to the next one.
    std::uint64_t to_next(std::uint64_t step) const { return rows_.to_next(step); }
    /// From now on a particle is followed; what is known of another one is forgotten.
    void follow(std::optional<std::size_t> particle);
    /// What was done to the run; what is known behind the first difference from before is forgotten.
    void follow(std::span<const SegmentBegin> changes);
    /// Takes one, if one belongs to this step and is not known. Both stand there.
    void offer(const Simulation& run, LiveEnsemble& ensemble);
    /// Copies what is new there.
    void put_into(SpreadSeries& series) const { rows_.put_into(series); }

private:
    StepSamples<SpreadSample> rows_;
    std::optional<std::size_t> particle_;
    std::vector<SegmentBegin> changes_;
    Frame frame_;  ///< kept for its memory
};

}  // namespace steplab
