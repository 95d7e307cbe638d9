#include "models/conservation.hpp"

#include <variant>

namespace steplab {

namespace {

Conservation without_drag(const ConstantForces& forces) {
    if (forces.step == 0 || forces.count < 2) return {};  // particle 0 is not accelerated
    return {.momentum = false, .angular_momentum = false, .cause = "constant forces"};
}

/// The fixed particle is at the origin, about which it exerts no torque.
Conservation without_drag(const LineForces& forces) {
    if (forces.gravity != 0) return {.momentum = false, .angular_momentum = false, .cause = "gravity"};
    if (forces.first_fixed) return {.momentum = false, .cause = "a fixed particle"};
    return {};
}

Conservation without_drag(const GridForces&) {
    return {.momentum = false, .angular_momentum = false, .cause = "fixed particles"};
}

Conservation without_drag(const PairForces&) { return {}; }

/// A force across the border of the box acts along the line to an image.
Conservation without_drag(const NearPairForces& forces) {
    if (forces.period > 0) return {.angular_momentum = false, .cause = "periodic boundary conditions"};
    return {};
}

Conservation without_drag(const ComposedForces& forces) {
    const Composition& terms = *forces.terms;
    if (!terms.accelerations.empty()) return {.momentum = false, .angular_momentum = false, .cause = "outer forces"};
    if (!terms.fixed.empty()) return {.momentum = false, .angular_momentum = false, .cause = "fixed particles"};
    if (terms.box != Vec3{}) return {.angular_momentum = false, .cause = "periodic boundary conditions"};
    return {};
}

}  // namespace

Conservation conservation(const Plan& scene) {
    if (scene.drag > 0) return {false, false, false, "drag"};
    return std::visit([](const auto& forces) { return without_drag(forces); }, scene.forces);
}

}  // namespace steplab
