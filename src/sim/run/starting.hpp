#pragma once

#include "core/field.hpp"
#include "core/shape.hpp"
#include "models/plan.hpp"
#include "models/scene/scene.hpp"
#include "sim/run/fixed_particles.hpp"
#include "sim/run/run_description.hpp"

#include <cstddef>
#include <memory>

namespace steplab {

/// Scenes of more particles have no start in a normal mode: finding all modes takes the third power of their number.
inline constexpr std::size_t most_in_modes = 300;

/// The plan with another start. Fixed particles have no velocity. Throws UsageError for values of another number of
/// particles.
Plan started(Plan plan, const StartChange& change);

/// The same as a scene file says it. Throws UsageError if the scene has no such mode, or too many particles for one.
Plan started(Plan plan, const Shape& shape, const SceneStart& start);

/// How the scene of a description is stepped, from where the description starts. Throws UsageError.
Plan plan_of(const RunDescription& description);

/// The state of a run of one plan as another plan of its scene goes on with it: counted from that one's reference
/// positions, and what is fixed there stands still where it is.
template <class T>
void carry_over(const Plan& from, const Plan& to, State<T>& state) {
    for (std::size_t i = 0; i < to.reference.count; ++i) {
        const Vec3 shift = from.reference.at(i) - to.reference.at(i);
        state.displacement.x()[i] += static_cast<T>(shift.x);
        state.displacement.y()[i] += static_cast<T>(shift.y);
        state.displacement.z()[i] += static_cast<T>(shift.z);
        if (is_fixed(to.forces, i)) state.velocity.set(i, {});
    }
}

/// The exact solution from that start, forward in time; null if none is known.
std::shared_ptr<const ExactSolution> exact_of(const RunDescription& description);

}  // namespace steplab
