#include "io/recorded_run.hpp"

#include "core/interruption.hpp"
#include "sim/run/confirmed_steps.hpp"
#include "sim/run/notes.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace steplab {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Diagnostics take memory of their own, which large scenes are spared.
std::optional<double> error_of(const Simulation& simulation) {
    constexpr std::size_t most_particles = 100000;
    return simulation.particles() <= most_particles ? simulation.diagnostics().error : std::nullopt;
}

}  // namespace

RunSummary record_run(Simulation& simulation, const RunEnd& end, std::uint64_t every,
                      const ShortWalks::Between& between, const std::function<void(const Simulation&)>& record) {
    const std::uint64_t steps = end.step;
    simulation.end_at(end);
    ConfirmedSteps stepping(steps, [&between](std::uint64_t step) {
        check_interruption();
        between(step);
    });
    const auto begin = Clock::now();
    const double energy_start = simulation.energy();
    double energy_error = 0;
    record(simulation);
    for (std::uint64_t recorded = 0; recorded < steps && !simulation.divergence();) {
        stepping.advance(simulation, std::min(steps, recorded + every));
        if (simulation.step() == recorded) break;  // no further step was valid
        recorded = simulation.step();
        energy_error = std::max(energy_error, std::abs(simulation.energy_error()));
        record(simulation);
    }
    const double wall_seconds = seconds_since(begin);
    return {.run = simulation.description(),
            .result = result_of(simulation, energy_start, energy_error),
            .wall_seconds = wall_seconds,
            .until = end.time,
            .error = error_of(simulation),
            .notes = notes_of_rounding(simulation)};
}

}  // namespace steplab
