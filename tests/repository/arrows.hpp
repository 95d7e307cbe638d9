#pragma once

#include "repository/files.hpp"

#include <string>
#include <vector>

namespace steplab::repository {

/// Each way in which a file under src/ goes against the arrows between the folders (docs/structure.md), as
/// "src/core/frame.hpp:3: core may not include sim/run/worker.hpp"; empty if all is well. What is looked at: includes
/// of our own headers, the libraries a folder's CMakeLists.txt links, and headers of OpenGL, window and interface
/// libraries in the folders that must do without them.
std::vector<std::string> forbidden_arrows(const std::vector<TextFile>& files);

}  // namespace steplab::repository
