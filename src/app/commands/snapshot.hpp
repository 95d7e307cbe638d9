#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab snapshot`: a picture of a run, drawn without a display.
std::unique_ptr<Command> snapshot_command();

}  // namespace steplab
