#include "io/recorded_run.hpp"

#include "core/interruption.hpp"
#include "core/larger_magnitude.hpp"
#include "sim/run/confirmed_steps.hpp"
#include "sim/run/notes.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace steplab {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

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
        energy_error = larger_magnitude(energy_error, simulation.energy_error());
        record(simulation);
    }
    const double wall_seconds = seconds_since(begin);
    RunResult result = result_of(simulation, energy_start, energy_error);
    result.error = error_at_end(simulation);
    return {.run = simulation.description(),
            .result = std::move(result),
            .wall_seconds = wall_seconds,
            .until = end.time,
            .notes = notes_of_rounding(simulation)};
}

}  // namespace steplab
