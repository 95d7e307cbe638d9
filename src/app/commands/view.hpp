#pragma once

#include "app/commands/command.hpp"

#include <memory>
#include <string>
#include <vector>

namespace steplab {

/// `steplab view SCENE`, `steplab SCENE` and `steplab`: checks the options and becomes `steplab-view`, the window
/// program in the same folder, with the same arguments. run() throws GraphicsError if that cannot be started.
std::unique_ptr<Command> view_command(std::vector<std::string> arguments);

}  // namespace steplab
