#pragma once

#include "lab/study/reference.hpp"
#include "sim/run/execution.hpp"
#include "sim/run/run_description.hpp"
#include "sim/run/run_result.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace steplab {

/// One run from the scene's start over a given time, and what it was found to be worth.
struct Measurement {
    RunDescription run;
    std::uint64_t steps = 0;             ///< asked for
    RunResult result = {};               ///< energy_error over the moments looked at
    double error = 0;                    ///< largest distance of a particle from the reference at the end
    double rms_error = 0;                ///< root of the mean squared distance over the particles
    std::optional<double> wall_seconds;  ///< of the stepping alone, least of several; none until timed
    double rough_seconds = 0;            ///< of the stepping when it was measured, whatever went on beside it

    /// Then error and wall_seconds mean nothing.
    bool diverged() const { return result.divergence.has_value(); }
};

/// Runs it once, looking at the energy at 64 moments. No error is given below the reference's own. `at_sample` is
/// called at each of them and may throw to end it.
Measurement measure(
    const RunDescription& run, std::uint64_t steps, const Reference& reference,
    const std::function<void()>& at_sample = [] {}, const Execution& execution = {});

/// Times the stepping of one run from a fresh start: nothing else is inside the clock, unless the method makes most of
/// its evaluations as it starts (an adaptive one whose first step reaches the end): then starting is too.
double stepping_seconds(const RunDescription& run, std::uint64_t steps);

}  // namespace steplab
