#include "sim/run/run_result.hpp"

namespace steplab {

RunResult result_of(const Simulation& simulation, double energy_start, double energy_error) {
    return {.dt = simulation.dt(),
            .steps = simulation.step(),
            .time = simulation.time(),
            .particles = simulation.particles(),
            .evaluations = simulation.evaluations(),
            .energy_start = energy_start,
            .energy_end = simulation.energy(),
            .energy_error = energy_error,
            .drag_work = simulation.drag_work(),
            .farthest = simulation.farthest(),
            .hash = simulation.hash(),
            .divergence = simulation.divergence(),
            .collisions = simulation.collisions()};
}

std::optional<double> error_at_end(const Simulation& simulation) {
    if (!simulation.has_exact() || simulation.particles() > most_particles_of_errors) return std::nullopt;
    return simulation.diagnostics().error;
}

}  // namespace steplab
