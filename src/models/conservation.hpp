#pragma once

#include "models/plan.hpp"

#include <string_view>

namespace steplab {

/// Which sums over all particles the exact motion of a scene keeps: what no method can keep is no merit of it.
struct Conservation {
    bool energy = true;            ///< false where drag takes it
    bool momentum = true;          ///< false where something outside of the particles acts on them
    bool angular_momentum = true;  ///< the same, about the origin
    std::string_view cause = {};   ///< of what changes: "drag", "gravity", "fixed particles" ...; empty if nothing does
};
Conservation conservation(const Plan& scene);

}  // namespace steplab
