#pragma once

#include "sim/run/execution.hpp"
#include "sim/run/run_description.hpp"
#include "sim/run/run_result.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace steplab {

/// One run of an ensemble.
struct EnsembleRun {
    RunDescription description;
    std::uint64_t steps = 0;
};

/// Its result, equal to that of a Simulation; energy_error is taken over every K-th step and the last.
struct EnsembleResult {
    RunResult result;
    bool in_lanes = false;  ///< computed with others in the lanes of vector registers; no bit depends on it
};

/// Computes runs that need not have anything in common, each bit for bit as a Simulation by itself: neighbours that
/// differ in numbers alone side by side in the lanes of vector registers where their method and scene allow it, and
/// groups of them on several threads. `every`, at least 1: K of energy_error. `watch` hears, from any of the threads
/// but one at a time, how many steps of all runs are done; what it throws ends the ensemble. Throws UsageError if a run
/// cannot be computed.
std::vector<EnsembleResult> run_ensemble(std::span<const EnsembleRun> runs, std::uint64_t every,
                                         const Execution& execution = {},
                                         const std::function<void(std::uint64_t)>& watch = {});

}  // namespace steplab
