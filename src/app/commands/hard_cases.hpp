#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab hard-cases [NAME] [--json]`: lists the scenes at which methods fail, or runs one with every method.
std::unique_ptr<Command> hard_cases_command();

}  // namespace steplab
