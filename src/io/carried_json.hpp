#pragma once

#include "models/scene/starting_values.hpp"
#include "models/scene_origin.hpp"

#include <nlohmann/json.hpp>

namespace steplab {

// What a run is made of beside numbers, as JSON: trajectories and summaries carry it, so that the run can be repeated.

/// The texts of a scene file and of the files it reads.
nlohmann::ordered_json json_of(const SceneFile& file);
/// Throws a std::exception for JSON that is not a scene.
SceneOrigin origin_of(const nlohmann::ordered_json& json);

/// Where the run starts.
nlohmann::ordered_json json_of(const StartChange& start);
/// Throws a std::exception for JSON that is not a start.
StartChange start_of(const nlohmann::ordered_json& json);

}  // namespace steplab
