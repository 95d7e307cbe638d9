#include "lab/study/measurement.hpp"

#include "core/flush_subnormals.hpp"
#include "core/larger_magnitude.hpp"
#include "sim/run/samples.hpp"
#include "sim/run/segment.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace steplab {

namespace {

constexpr std::uint64_t samples_of_energy = 64;

void compare(Measurement& measurement, const State<double>& end, const Reference& reference) {
    measurement.error = error_against(reference.moments.back(), end.displacement);
    measurement.rms_error = rms_error_against(reference.moments.back(), end.displacement);
}

/// Measures the time of stepping, and of the start if the method makes most of its evaluations there.
class SteppingClock {
public:
    void started(std::uint64_t evaluations) {
        start_ = since(begin_);
        at_start_ = evaluations;
    }
    template <class Steps>
    void time(const Steps& steps) {
        const auto begin = Clock::now();
        steps();
        stepping_ += since(begin);
    }
    double seconds(std::uint64_t evaluations) const { return stepping_ + (2 * at_start_ > evaluations ? start_ : 0); }

private:
    using Clock = std::chrono::steady_clock;
    static double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

    Clock::time_point begin_ = Clock::now();
    std::uint64_t at_start_ = 0;
    double start_ = 0, stepping_ = 0;
};

}  // namespace

Measurement measure(const RunDescription& run, std::uint64_t steps, const Reference& reference,
                    const std::function<void()>& at_sample, const Execution& execution) {
    Measurement measurement{.run = run, .steps = steps, .wall_seconds = {}};
    SteppingClock clock;
    Simulation simulation(run, execution);
    clock.started(simulation.evaluations());
    const double energy_start = simulation.energy();
    double energy_error = 0;
    Samples samples(steps, samples_of_energy);
    const auto advance = [&] {
        at_sample();
        bool more = false;
        clock.time([&] { more = samples.advance(simulation); });
        return more;
    };
    while (advance()) energy_error = larger_magnitude(energy_error, simulation.energy_error());
    measurement.result = result_of(simulation, energy_start, energy_error);
    measurement.rough_seconds = clock.seconds(measurement.result.evaluations);
    if (!measurement.diverged()) compare(measurement, simulation.state(), reference);
    return measurement;
}

double stepping_seconds(const RunDescription& run, std::uint64_t steps) {
    SteppingClock clock;
    const Segment segment(run);
    clock.started(segment.stepper->evaluations());
    const FlushSubnormals flush;
    clock.time([&] { segment.stepper->advance(steps); });
    return clock.seconds(segment.stepper->evaluations());
}

}  // namespace steplab
