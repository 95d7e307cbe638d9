#pragma once

#include "models/plan.hpp"

#include <string_view>

namespace steplab {

/// Which sums over all particles the exact motion of a scene keeps: what no method can keep is no merit of it.
struct Conservation {
    bool energy = true;            ///< false where drag or dashpots take it
    bool momentum = true;          ///< false where something outside of the moving particles acts on them
    bool angular_momentum = true;  ///< the same, about the origin
    /// What changes them: "drag", "gravity", "fixed particles" ...; the cause of a momentum that changes before that of
    /// an angular momentum, and of that before that of the energy. Empty if nothing does.
    std::string_view cause = {};
};
/// Takes a pass over the particles, springs and pair forces of a composed scene.
Conservation conservation(const Plan& scene);

}  // namespace steplab
