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
    RunEnd end;
    /// Measured too, where they are known: the work of drag, of runs that then do not share lanes, and the error.
    bool with_errors = false;
};

/// Its result, equal to that of a Simulation; energy_error is taken over every K-th step and the last.
struct EnsembleResult {
    RunResult result;
    bool in_lanes = false;  ///< computed with others in the lanes of vector registers; no bit depends on it
};

/// Computes independent runs, each bit for bit as a Simulation alone: neighbours in the list that differ only in
/// numbers in SIMD lanes where their method and scene allow it, and batches of them on several threads. `every`, at
/// least 1: K of energy_error. `watch` is called, from any of the threads but one at a time, with the number of steps
/// done in all runs; what it throws ends the ensemble. Throws UsageError if a run cannot be computed.
std::vector<EnsembleResult> run_ensemble(std::span<const EnsembleRun> runs, std::uint64_t every,
                                         const Execution& execution = {},
                                         const std::function<void(std::uint64_t)>& watch = {});

}  // namespace steplab
