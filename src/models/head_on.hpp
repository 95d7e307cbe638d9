#pragma once

#include "models/model.hpp"

#include <memory>

namespace steplab {

/// Two particles under the Morse potential on the x axis, in closed form (docs/exact.md): particle 0 starts at rest at
/// the origin, particle 1 at `start` < 0 with velocity v0 along x. Valid until they touch; null if its numbers
/// overflow.
std::shared_ptr<const ExactSolution> head_on_solution(const PairForces& pair, double start, double v0);

}  // namespace steplab
