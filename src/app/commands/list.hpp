#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab list [models|methods] [--json]`: the catalogue.
std::unique_ptr<Command> list_command();

}  // namespace steplab
