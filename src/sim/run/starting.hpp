#pragma once

#include "core/shape.hpp"
#include "models/scene/scene.hpp"
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

/// The exact solution from that start, forward in time; null if none is known.
std::shared_ptr<const ExactSolution> exact_of(const RunDescription& description);

}  // namespace steplab
