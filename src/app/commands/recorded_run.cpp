#include "app/commands/recorded_run.hpp"

#include "io/interruption.hpp"
#include "sim/run/confirmed_steps.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace steplab {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

void describe(const Simulation& simulation, RunSummary& summary) {
    const RunDescription& description = simulation.description();
    summary.model = description.model;
    summary.method = description.method;
    summary.precision = description.precision;
    summary.dt = simulation.dt();
    summary.steps = simulation.step();
    summary.time = simulation.time();
    summary.particles = simulation.particles();
    summary.evaluations = simulation.evaluations();
    summary.hash = simulation.hash();
    summary.collisions = simulation.collisions();
    summary.drag = has_drag(description);
    if (simulation.divergence()) summary.diverged_step = simulation.step() + 1;
}

}  // namespace

RunSummary record_run(Simulation& simulation, std::uint64_t steps, std::uint64_t every, Progress& progress,
                      const std::function<void(const Simulation&)>& record) {
    ConfirmedSteps stepping(steps, [&progress](std::uint64_t step) {
        check_interruption();
        progress.at(step);
    });
    const auto begin = Clock::now();
    RunSummary summary;
    summary.energy_start = simulation.energy();
    record(simulation);
    for (std::uint64_t recorded = 0; recorded < steps && !simulation.divergence();) {
        stepping.advance(simulation, std::min(steps, recorded + every));
        if (simulation.step() == recorded) break;  // no step more was good
        recorded = simulation.step();
        summary.energy_error = std::max(summary.energy_error, std::abs(simulation.energy_error()));
        record(simulation);
    }
    summary.energy_end = simulation.energy();
    summary.wall_seconds = seconds_since(begin);
    describe(simulation, summary);
    return summary;
}

}  // namespace steplab
