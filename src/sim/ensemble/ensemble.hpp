#pragma once

#include "core/collision.hpp"
#include "sim/run/execution.hpp"
#include "sim/run/run_description.hpp"
#include "sim/run/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace steplab {

/// One run of an ensemble.
struct EnsembleRun {
    RunDescription description;
    std::uint64_t steps = 0;
};

/// Its result: that of a Simulation after its last step.
struct EnsembleResult {
    double dt = 0;            ///< as the precision holds it
    std::uint64_t steps = 0;  ///< taken; up to the last good one
    double time = 0;          ///< reached
    std::size_t particles = 0;
    std::uint64_t evaluations = 0;
    double energy_start = 0;
    double energy_end = 0;
    double energy_error = 0;  ///< largest |E - E0| over every K-th step and the last
    std::string hash;
    std::optional<Divergence> divergence;
    CollisionRecord collisions;
    bool in_lanes = false;  ///< computed with others in the lanes of vector registers; no bit depends on it
};

/// Computes independent runs, each bit for bit as a Simulation alone: neighbours in the list that differ only in numbers
/// in SIMD lanes where their method and scene allow it, and batches of them on several threads. `every`, at least 1: K
/// of energy_error. `watch` is called, from any of the threads but one at a time, with the number of steps done in all
/// runs; what it throws ends the ensemble. Throws UsageError if a run cannot be computed.
std::vector<EnsembleResult> run_ensemble(std::span<const EnsembleRun> runs, std::uint64_t every,
                                         const Execution& execution = {},
                                         const std::function<void(std::uint64_t)>& watch = {});

}  // namespace steplab
