#pragma once

#include "models/plan.hpp"

namespace steplab {

/// The angular frequency of the motion that a scene starts with: the root of the Rayleigh quotient of its stiffness for
/// the velocities of its start, or for the accelerations if it starts at rest. 0 if nothing drives that motion back.
/// Takes memory for some states of the scene, and two evaluations.
double start_frequency(const Plan& scene);

}  // namespace steplab
