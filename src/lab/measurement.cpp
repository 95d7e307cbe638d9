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
    double squares = 0;
    const std::size_t particles = end.displacement.count();
    for (std::size_t i = 0; i < particles; ++i) {
        const double distance = reference.distance(end.displacement, i);
        measurement.error = std::max(measurement.error, distance);
        squares += distance * distance;
    }
    measurement.rms_error = std::sqrt(squares / static_cast<double>(particles));
    measurement.error = std::max(measurement.error, reference.error);
    measurement.rms_error = std::max(measurement.rms_error, reference.error);
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
