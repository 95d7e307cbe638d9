#pragma once

#include "models/model.hpp"
#include "models/scene/scene.hpp"

namespace steplab {

/// What is known of a scene from its terms, whoever wrote them. Throws UsageError where it names what it does not have.
SceneFacts facts_of(const Scene& scene);

}  // namespace steplab
