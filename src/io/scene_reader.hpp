#pragma once

#include "io/particle_files.hpp"
#include "io/scene_parameters.hpp"
#include "models/scene/scene.hpp"

#include <string>

namespace steplab {

/// What a scene file says beside its scene.
struct SceneTexts {
    std::string title, teaches, topic;
    SceneDefaults defaults;
};

/// The scene of a parsed file for the values that `numbers` has; `files` are those it reads. Throws the SceneProblem
/// that comes first in the file.
Scene read_scene(const toml::table& root, SceneNumbers& numbers, ParticleFiles& files);

/// The texts and the [run] and [view] of a file. Throws SceneProblem.
SceneTexts read_texts(const toml::table& root, SceneNumbers& numbers);

}  // namespace steplab
