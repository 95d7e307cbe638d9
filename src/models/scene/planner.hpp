#pragma once

#include "core/shape.hpp"
#include "models/plan.hpp"
#include "models/scene/scene.hpp"

#include <string>

namespace steplab {

/// How a scene is stepped. What a fast layout of forces does is recognised whoever wrote it: a line of equal springs, a
/// grid of equal springs with a fixed border, one Morse potential between all particles or those within a cut-off. The
/// rest goes to the composed layout. Throws UsageError where a scene cannot be stepped.
Plan planned(const Scene& scene);

/// What of a scene does not change while it runs.
Shape shape_of(const Scene& scene);

}  // namespace steplab
