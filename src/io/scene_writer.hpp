#pragma once

#include "sim/run/run_description.hpp"

#include <string>

namespace steplab {

/// A scene file of the scene of a run, whose parameters have their values there: running it gives the same hash.
std::string scene_file_text(const RunDescription& run);

}  // namespace steplab
