#pragma once

#include "core/collision.hpp"
#include "sim/run/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace steplab {

/// The numbers of a run at its end.
struct RunResult {
    double dt = 0;            ///< as the precision holds it
    std::uint64_t steps = 0;  ///< taken; if the run diverged, up to the last valid one
    double time = 0;          ///< reached
    std::size_t particles = 0;
    std::uint64_t evaluations = 0;  ///< of the forces, start-up included
    double energy_start = 0;
    double energy_end = 0;
    double energy_error = 0;  ///< largest |E - E0| over the steps at which it was measured, drag_work added if counted
    std::optional<double> drag_work = {};  ///< what drag took, where it was counted
    std::optional<double> error = {};      ///< of a position at the end, where measured (error_at_end())
    double farthest = 0;                   ///< largest displacement from the reference positions at the end
    std::string hash = {};
    std::optional<Divergence> divergence = {};
    CollisionRecord collisions = {};  ///< that an adaptive method found and restarted from

    /// "ok", "diverged", or "stopped" where no step of the method met its tolerance.
    std::string status() const { return !divergence ? "ok" : divergence->stop ? "stopped" : "diverged"; }
    /// The step in which the run diverged or stopped. None if it did not.
    std::optional<std::uint64_t> diverged_step() const { return divergence ? std::optional(steps + 1) : std::nullopt; }
};

/// The result of a run that stands at its last step. The energy at its start and the largest energy error on the way
/// are the caller's measurements.
RunResult result_of(const Simulation& simulation, double energy_start, double energy_error);

/// Largest distance of a particle from the exact solution, where one is known at this time. Not measured of more than
/// 100 000 particles, whose diagnostics take memory of their own.
inline constexpr std::size_t most_particles_of_errors = 100000;
std::optional<double> error_at_end(const Simulation& simulation);

}  // namespace steplab
