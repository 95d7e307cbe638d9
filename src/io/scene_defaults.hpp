#pragma once

#include "io/particle_files.hpp"
#include "io/scene_parameters.hpp"
#include "models/scene/scene.hpp"

namespace steplab {

/// The [run] of a scene file. Throws SceneProblem.
void read_run(const toml::node& node, SceneNumbers& numbers, SceneDefaults& defaults);

/// The [start] of a scene file. Throws SceneProblem.
SceneStart scene_start(const toml::node& node, SceneNumbers& numbers, ParticleFiles& files);
/// Throws SceneProblem unless this start is possible for so many particles.
void check_start(const toml::table& root, const SceneStart& start, std::size_t particles);

}  // namespace steplab
