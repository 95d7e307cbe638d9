#pragma once

#include "io/scene_toml.hpp"
#include "models/scene/scene.hpp"

#include <string>

namespace steplab {

// What a scene file says of how its scene opens, beside the scene. All throw SceneProblem.

/// The values of the method's own parameters; `defaults` has the method that they belong to.
void read_method_parameters(const toml::node& node, SceneDefaults& defaults);

/// The table [view].
void read_view(const toml::node& node, SceneDefaults& defaults);

/// One of topic_ids.
std::string read_topic(const toml::node& node);

}  // namespace steplab
