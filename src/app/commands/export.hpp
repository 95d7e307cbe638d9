#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab export SCENE --to scene [--out FILE|-]`: the scene as a file for --scene.
std::unique_ptr<Command> export_command();

}  // namespace steplab
