#pragma once

#include "models/model.hpp"

#include <memory>

namespace steplab {

/// The exact motion of particles that do not act on each other, each with an acceleration from outside that stays the
/// same, with drag or without. Null for other scenes.
std::shared_ptr<const ExactSolution> known_fall(const Plan& plan);

}  // namespace steplab
