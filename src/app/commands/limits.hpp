#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab limits SCENE [--method all] [--json]`: the largest stable dt, by theory and by runs.
std::unique_ptr<Command> limits_command();

}  // namespace steplab
