#pragma once

#include "models/forces/composition.hpp"
#include "models/scene/scene_particles.hpp"

#include <string_view>
#include <vector>

namespace steplab {

/// A pair potential that has a name, and the values it takes.
struct BuiltInPotential {
    struct Value {
        std::string_view name;
        double ComposedPairs::*member;
        bool required = true;  ///< else 0 where it is not given
    };
    std::string_view name;
    ComposedPairs::Potential potential;
    std::vector<Value> values;
};
/// Null if there is none of this name.
const BuiltInPotential* built_in_potential(std::string_view name);

/// The forces of any scene, for the composed layout. Throws UsageError for what it does not have.
Composition composed(const Scene& scene, const SceneParticles& particles);

/// gamma = c / m of the drag that acts on all particles. Throws UsageError where it is not the same for all.
double rate_of_drag(const Scene& scene, const SceneParticles& particles);

}  // namespace steplab
