#pragma once

#include "io/particle_files.hpp"
#include "io/scene_parameters.hpp"
#include "io/scene_problems.hpp"
#include "models/scene/scene.hpp"

#include <string>

namespace steplab {

/// What a scene file says beside its scene.
struct SceneTexts {
    std::string title, teaches, topic;
    SceneDefaults defaults;
};

/// How much of a scene is read.
struct SceneReading {
    double bytes_per_particle = 0;  ///< that a run takes at least: more particles than fit into `memory` are a problem
    double memory = 0;              ///< [bytes] when the file was opened; the program itself takes of it
    bool checks = true;             ///< also what blocks mean together
    bool starts_are_known = false;  ///< to be where potentials are finite
};

/// The scene of a parsed file for the values that `numbers` has; `files` are those it reads. What is wrong with it is
/// added to the problems; then the scene is not to be used.
Scene read_scene(const toml::table& root, SceneNumbers& numbers, ParticleFiles& files, const SceneReading& how,
                 SceneProblems& problems);

/// The texts and the [run] and [view] of a file. What is wrong with them is added to the problems; throws SceneProblem
/// for a file of another version.
SceneTexts read_texts(const toml::table& root, SceneNumbers& numbers, SceneProblems& problems);

}  // namespace steplab
