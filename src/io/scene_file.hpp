#pragma once

#include "models/model.hpp"
#include "models/scene/scene.hpp"
#include "models/scene_origin.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace steplab {

/// The scene of a TOML file (docs/scene-files.md). Throws FileError: "FILE:LINE:COLUMN: what is wrong; what would be
/// right", the first in file order.
SceneOrigin read_scene_file(const std::string& path);

/// The names of the scenes that come with the program, in order.
std::vector<std::string> shipped_scenes();

/// The file of --scene NAME; empty if no shipped scene has this name.
std::filesystem::path scene_path(const std::string& name);

/// The scene of --scene: a text with a slash, or that ends in .toml, is a file, any other the name of a shipped scene.
/// Throws FileError, or UsageError that names the nearest scene.
SceneOrigin find_scene(const std::string& name);

/// The same of what the file holds; `name` stands for it in messages.
SceneOrigin scene_from(std::vector<SceneFile::Part> parts, const std::string& name);

}  // namespace steplab
