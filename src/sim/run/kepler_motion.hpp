#pragma once

#include "models/model.hpp"

#include <memory>

namespace steplab {

/// The exact motion of two particles that attract each other by 1 / r^2 and nothing else; one of them may be fixed.
/// Null for other scenes, and for orbits that are not ellipses.
std::shared_ptr<const ExactSolution> kepler_motion(const Plan& plan);

}  // namespace steplab
