#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab record`: a film of a run, drawn without a display.
std::unique_ptr<Command> record_command();

}  // namespace steplab
