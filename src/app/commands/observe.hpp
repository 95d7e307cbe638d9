#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab observe`: what is measured of the frames of a file.
std::unique_ptr<Command> observe_command();

}  // namespace steplab
