#pragma once

#include "sim/run/run_description.hpp"

#include <string>

namespace steplab {

/// How a scene is shown, as [view] says it; what is empty is left out.
struct SceneView {
    std::string camera = {}, colour = {}, background = {};
};

/// A scene file of the scene of a run, whose parameters have their values there: running it gives the same hash. What
/// the run's own scene file says of its length, its view and its topic is kept.
std::string scene_file_text(const RunDescription& run);
/// The same with another view.
std::string scene_file_text(const RunDescription& run, const SceneView& view);

}  // namespace steplab
