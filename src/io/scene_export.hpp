#pragma once

#include "io/scene_writer.hpp"

#include <string>

namespace steplab {

/// Writes the scene of a run, as the run starts it, to a file, or to standard output (-). Beside a file lie those that
/// the scene reads, and NAME-start.csv with the values of the run's --from, or of the moment of a trajectory from which
/// the scene starts, unless that trajectory lies there. Throws FileError, also where a file that
/// the scene reads is there with other content, and UsageError for standard output if there are such values.
void write_scene(const std::string& out, const RunDescription& run, const SceneView& view);
/// The same as the run's own scene file is shown.
void write_scene(const std::string& out, const RunDescription& run);

}  // namespace steplab
