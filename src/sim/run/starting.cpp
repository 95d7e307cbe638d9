#include "sim/run/starting.hpp"

#include "core/error.hpp"
#include "core/frame.hpp"
#include "sim/run/fixed_particles.hpp"
#include "sim/run/linearised.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace steplab {

namespace {

/// With all digits of the file where it counts from the same reference positions.
Vec3 displacement_of(const StartingValues& values, std::size_t i, Vec3 reference) {
    const Vec3 position = values.positions[i];
    if (!values.displacements.empty()) {
        const Vec3 displacement = values.displacements[i];
        for (const Precision precision : {Precision::double_, Precision::float_}) {
            if (position_of(reference, displacement, precision) == position) return displacement;
        }
    }
    return position - reference;
}

Start start_from(const std::shared_ptr<const StartingValues>& values, const Plan& plan) {
    const std::size_t count = plan.reference.count;
    if (values->positions.size() != count)
        throw UsageError(
            fmt::format("'{}' holds {} particles, the scene has {}", values->given, values->positions.size(), count));
    return {count, [values, forces = plan.forces, reference = plan.reference](std::size_t i) {
                const bool fixed = is_fixed(forces, i);
                return Start::Particle{displacement_of(*values, i, reference.at(i)),
                                       fixed ? Vec3{} : values->velocities[i]};
            }};
}

/// Subtracted from zero, so that what rests has no -0.
Start reversed(const Start& start) {
    return {start.count(), [start](std::size_t i) {
                const Start::Particle particle = start[i];
                return Start::Particle{particle.displacement, Vec3{} - particle.velocity};
            }};
}

/// The place of a mode among the ascending eigenvalues omega^2.
Eigen::Index place_of(std::size_t mode, const Eigen::VectorXd& values) {
    const Eigen::Index all = values.size(), left_out = count_of_still(values),
                       place = left_out + static_cast<Eigen::Index>(mode) - 1;
    if (place < all) return place;
    throw UsageError(
        fmt::format("there is no normal mode {}: the scene has {} of a frequency > 0", mode, all - left_out));
}

/// The displacements of a normal mode of which the largest is 1 along its largest component.
Field<double> mode_of(const Plan& plan, const Shape& shape, std::size_t mode) {
    if (plan.reference.count > most_in_modes)
        throw UsageError(fmt::format("normal modes are computed of at most {} particles, the scene has {}",
                                     most_in_modes, plan.reference.count));
    const LinearisedScene scene(plan, shape);
    const Eigenpairs all = all_modes(scene);
    Field<double> field = scene.displacements(all.vectors.col(place_of(mode, all.values)));
    double largest = 0, sign = 1, component = 0;
    for (std::size_t i = 0; i < field.count(); ++i) {
        const Vec3 at = field.at(i);
        largest = std::max(largest, length(at));
        for (const double along : {at.x, at.y, at.z}) {
            if (std::abs(along) > component) component = std::abs(along), sign = along < 0 ? -1 : 1;
        }
    }
    for (double& number : field.flat()) number *= sign / largest;
    return field;
}

Start vibrating(const Plan& plan, const Shape& shape, const SceneStart& start) {
    State<double> state = plan.start.state();
    const Field<double> mode = mode_of(plan, shape, start.mode);
    for (std::size_t i = 0; i < mode.count(); ++i)
        state.displacement.set(i, state.displacement.at(i) + start.amplitude.value * mode.at(i));
    return Start(std::move(state));
}

}  // namespace

Plan started(Plan plan, const StartChange& change) {
    if (change.from) plan.start = start_from(change.from, plan);
    if (change.reverse) plan.start = reversed(plan.start);
    return plan;
}

Plan started(Plan plan, const Shape& shape, const SceneStart& start) {
    if (start.change.from) plan.start = start_from(start.change.from, plan);
    if (start.mode > 0) plan.start = vibrating(plan, shape, start);
    if (start.change.reverse) plan.start = reversed(plan.start);
    return plan;
}

Plan plan_of(const RunDescription& description) {
    return started(model_of(description).plan(description.scene), description.start);
}

std::shared_ptr<const ExactSolution> exact_of(const RunDescription& description) {
    return description.start.is_none() && description.dt > 0 ? model_of(description).exact(description.scene) : nullptr;
}

}  // namespace steplab
