#include "session/compared.hpp"

#include "core/clamped.hpp"
#include "core/shape.hpp"
#include "lab/study/distances.hpp"

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

/// Over the particles that are not fixed; 0 where all are.
double rms_distance(const Field<double>& a, const Field<double>& b, const Shape& shape) {
    double squares = 0, moving = 0;
    for (std::size_t i = 0; i < a.count(); ++i) {
        if (shape.roles[i] == Role::fixed) continue;
        const Vec3 between = a.at(i) - b.at(i);
        squares += dot(between, between);
        ++moving;
    }
    return moving > 0 ? std::sqrt(squares / moving) : 0;
}

std::optional<double> phase_error_of(const Field<double>& run, const State<double>& motion) {
    double along = 0, square = 0;
    for (std::size_t i = 0; i < run.count(); ++i) {
        const Vec3 velocity = motion.velocity.at(i);
        along += dot(run.at(i) - motion.displacement.at(i), velocity);
        square += dot(velocity, velocity);
    }
    return square > 0 ? std::optional(along / square) : std::nullopt;
}

}  // namespace

std::uint64_t step_at(double time, double dt) {
    constexpr std::uint64_t most = 9007199254740992;  // steps that a double can count
    return clamped_floor<std::uint64_t>(time / dt + 1e-6, 0, most);
}

std::optional<double> energy_error_of(const Simulation& run) {
    if (has_drag(run.description()) && !run.drag_work()) return std::nullopt;
    return run.energy_error();
}

RunMoment moment_of(const Simulation& run, Vec3 start) {
    RunMoment moment{.step = run.step(),
                     .time = run.time(),
                     .displacement = run.state().displacement,
                     .shape = run.shape(),
                     .energy_error = energy_error_of(run),
                     .momentum_error = {},
                     .evaluations = run.evaluations()};
    if (run.conservation().momentum && run.baseline_step() == 0) {
        const Vec3 change = run.diagnostics().momentum - start;
        moment.momentum_error = std::sqrt(dot(change, change));
    }
    return moment;
}

Compared compared(const RunMoment& run, const ReferenceMoment& reference, bool exact) {
    const Field<double>& there = reference.state.displacement;
    return {.step = run.step,
            .time = run.time,
            .error = largest_distance(there, run.displacement),
            .rms_error = rms_distance(there, run.displacement, *run.shape),
            .energy_error = run.energy_error,
            .momentum_error = run.momentum_error,
            .phase_error = phase_error_of(run.displacement, reference.state),
            .reference_error = exact ? 0 : reference.error,
            .evaluations = run.evaluations};
}

}  // namespace steplab
