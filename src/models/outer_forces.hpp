#pragma once

#include "models/plan.hpp"

#include <string_view>

namespace steplab {

/// What acts on the moving particles of a scene from outside, fixed particles left out.
struct OuterForces {
    bool net = false;             ///< their sum is not 0
    bool central = true;          ///< each of them acts along the line to the origin
    std::string_view cause = {};  ///< "gravity", "outer forces"; empty if there are none
};
/// Of the scene of these terms. Whether a potential is one of the distance from the origin alone is found by its forces
/// near particles and far from them.
OuterForces outer_forces(const Plan& scene, const Composition& terms);

}  // namespace steplab
