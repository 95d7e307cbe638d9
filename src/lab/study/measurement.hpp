#pragma once

#include "lab/study/reference.hpp"
#include "sim/run/execution.hpp"
#include "sim/run/run_description.hpp"
#include "sim/run/run_result.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace steplab {

/// One run from the scene's start over a given time, with its errors and its cost.
struct Measurement {
    RunDescription run;
    std::uint64_t steps = 0;             ///< requested
    RunResult result = {};               ///< energy_error over 64 samples
    double error = 0;                    ///< largest distance of a particle from the reference at the end
    double rms_error = 0;                ///< root of the mean squared distance over the particles
    std::optional<double> wall_seconds;  ///< of the stepping alone, minimum of several; nullopt until timed
    double rough_seconds = 0;            ///< of the stepping, measured under any other load of the machine

    /// If true, error and wall_seconds are meaningless.
    bool diverged() const { return result.divergence.has_value(); }
};

/// Runs it once and samples its energy 64 times. Errors are not smaller than that of the reference. `at_sample` is
/// called at each sample and may throw to end the run.
Measurement measure(
    const RunDescription& run, std::uint64_t steps, const Reference& reference,
    const std::function<void()>& at_sample = [] {}, const Execution& execution = {});

/// Measures the time of the steps of one run, start excluded; the start is included if the method makes most of its
/// evaluations there (an adaptive method whose first step reaches the end).
double stepping_seconds(const RunDescription& run, std::uint64_t steps);

}  // namespace steplab
