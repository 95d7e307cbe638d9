#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab advise`: the fastest method, dt and precision for a scene and an allowed error.
std::unique_ptr<Command> advise_command();

}  // namespace steplab
