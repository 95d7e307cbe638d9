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

Measurement measure(const RunDescription& run, std::uint64_t steps, const Reference& reference) {
    Measurement measurement{.run = run, .steps = steps, .wall_seconds = {}, .hash = {}};
    Simulation simulation(run);
    for (std::uint64_t look = 1; look <= looks && !simulation.divergence(); ++look) {
        simulation.advance(steps * look / looks - simulation.step());
        measurement.energy_error = std::max(measurement.energy_error, std::abs(simulation.diagnostics().energy_error));
    }
    simulation.conclude();
    measurement.evaluations = simulation.evaluations();
    measurement.diverged = simulation.divergence().has_value();
    measurement.hash = simulation.hash();
    if (!measurement.diverged) compare(measurement, simulation.state(), reference);
    return measurement;
}

double stepping_seconds(const RunDescription& run, std::uint64_t steps) {
    const Segment segment(run);
    const FlushSubnormals flush;
    const auto begin = std::chrono::steady_clock::now();
    segment.stepper->advance(steps);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace steplab
