#include "lab/measurement.hpp"

#include "core/flush_subnormals.hpp"
#include "sim/segment.hpp"
#include "sim/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace steplab {

namespace {

constexpr std::uint64_t looks = 64;

void compare(Measurement& measurement, const State<double>& end, const Reference& reference) {
    measurement.error = error_against(reference.moments.back(), end.displacement);
    measurement.rms_error = rms_error_against(reference.moments.back(), end.displacement);
}

}  // namespace

Measurement measure(const RunDescription& run, std::uint64_t steps, const Reference& reference,
                    const std::function<void()>& at_look) {
    Measurement measurement{.run = run, .steps = steps, .wall_seconds = {}, .hash = {}};
    Simulation simulation(run);
    for (std::uint64_t look = 1; look <= looks && !simulation.divergence(); ++look) {
        at_look();
        simulation.advance(steps * look / looks - simulation.step());
        measurement.energy_error = std::max(measurement.energy_error, std::abs(simulation.energy_error()));
    }
    simulation.conclude();
    measurement.evaluations = simulation.evaluations();
    measurement.diverged = simulation.divergence().has_value();
    measurement.hash = simulation.hash();
    if (!measurement.diverged) compare(measurement, simulation.state(), reference);
    return measurement;
}

double stepping_seconds(const RunDescription& run, std::uint64_t steps) {
    using Clock = std::chrono::steady_clock;
    const auto before = Clock::now();
    const Segment segment(run);
    const std::uint64_t at_start = segment.stepper->evaluations();
    const FlushSubnormals flush;
    const auto begin = Clock::now();
    segment.stepper->advance(steps);
    const auto end = Clock::now();
    const bool starting_is_the_work = 2 * at_start > segment.stepper->evaluations();
    return std::chrono::duration<double>(end - (starting_is_the_work ? before : begin)).count();
}

}  // namespace steplab
