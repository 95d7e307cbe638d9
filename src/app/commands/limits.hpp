#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab limits SCENE [--method all] [--json]`: the largest stable dt, from theory and measured on runs.
std::unique_ptr<Command> limits_command();

}  // namespace steplab
