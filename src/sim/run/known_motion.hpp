#pragma once

#include "models/model.hpp"

#include <memory>
#include <optional>

namespace steplab {

// What is known in closed form of scenes that are no models of the catalogue, by what the planner makes of them.

/// The exact motion from the plan's start: of linear springs in a line that move along it, with their modes, as long as
/// no particle passes another; of two particles that attract each other by 1 / r^2 on an ellipse; and of any that fall
/// without acting on each other, with drag or without. Null for others.
std::shared_ptr<const ExactSolution> known_motion(const Plan& plan);

/// The largest angular frequency of a scene of linear springs.
struct KnownFrequency {
    double omega = 0;
    bool is_bound = false;  ///< an upper bound, of any position of the particles
};
/// None where other forces act. Of many particles on springs in any order it is a bound: twice the sum of the force
/// constants at a particle by its mass.
std::optional<KnownFrequency> known_frequency(const Plan& plan, const Shape& shape);

}  // namespace steplab
