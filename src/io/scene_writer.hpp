#pragma once

#include "sim/run/run_description.hpp"

#include <string>

namespace steplab {

/// How a scene is shown, as [view] says it; what is empty is left out.
struct SceneView {
    std::string camera = {}, colour = {}, background = {};
};

/// As the run's own scene file says it; empty for a model.
SceneView view_of(const RunDescription& run);

/// A scene file of the scene of a run, whose parameters have their values there: running it gives the same hash. What
/// the run's own scene file says of its length, its view and its topic is kept.
std::string scene_file_text(const RunDescription& run);
/// The same with another view, and with the start of the run: `start_file` is the name of the file of its values,
/// those of --from or of the scene's own [start]; without it, that of the scene.
std::string scene_file_text(const RunDescription& run, const SceneView& view, const std::string& start_file = {});

/// The same in a text that reads no other file: the particles of files are written out, if the rest of the scene does
/// not name them as a group. Throws UsageError that says why there is none.
std::string whole_scene_text(const RunDescription& run);

}  // namespace steplab
