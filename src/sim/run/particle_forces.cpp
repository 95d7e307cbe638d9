#include "sim/run/particle_forces.hpp"

#include "models/forces/layouts.hpp"

#include <memory>
#include <variant>

namespace steplab {

namespace {

/// Without the drag that is the same for all.
template <class Force>
void accelerate(Force& force, const State<double>& state, Field<double>& a) {
    force.accelerations(state.displacement, a);
    if constexpr (Force::capabilities.damping) {
        if (force.damped()) force.add_damping(state.displacement, state.velocity, a);
    }
}

}  // namespace

ParticleForces::ParticleForces(const Plan& scene) : mass_(scene.mass), drag_(scene.drag), masses_(scene.masses) {
    std::visit(
        [&](const auto& layout) {
            using Force = decltype(engine<double>(layout));
            const auto force = std::make_shared<Force>(engine<double>(layout));
            accelerate_ = [force](const State<double>& state, Field<double>& a) { accelerate(*force, state, a); };
        },
        scene.forces);
}

void ParticleForces::at(const State<double>& state, std::vector<Vec3>& out) {
    const std::size_t count = state.displacement.count();
    if (accelerations_.count() != count) accelerations_ = Field<double>(count);
    accelerate_(state, accelerations_);
    out.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double mass = mass_ * (masses_.empty() ? 1 : masses_[i]);
        out[i] = mass * (accelerations_.at(i) - drag_ * state.velocity.at(i));
    }
}

}  // namespace steplab
