#include "session/compared.hpp"

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

}  // namespace

std::uint64_t step_at(double time, double dt) {
    constexpr double most = 9007199254740992.0;  // steps that a double can count
    return static_cast<std::uint64_t>(std::clamp(std::floor(time / dt + 1e-6), 0.0, most));
}

RunErrors::RunErrors(const Simulation& run) : momentum_(run.diagnostics().momentum) {}

Compared RunErrors::of(const Simulation& run, const ReferenceMoment& reference, bool exact) const {
    const Field<double>& there = run.state().displacement;
    Compared compared{.step = run.step(),
                      .time = run.time(),
                      .error = largest_distance(reference.state.displacement, there),
                      .rms_error = rms_distance(reference.state.displacement, there, *run.shape()),
                      .energy_error = {},
                      .momentum_error = {},
                      .reference_error = exact ? 0 : reference.error,
                      .evaluations = run.evaluations()};
    if (!has_drag(run.description()) || run.drag_work()) compared.energy_error = run.energy_error();
    if (run.conservation().momentum) {
        const Vec3 change = run.diagnostics().momentum - momentum_;
        compared.momentum_error = std::sqrt(dot(change, change));
    }
    return compared;
}

}  // namespace steplab
