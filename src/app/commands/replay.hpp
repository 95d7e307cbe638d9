#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// steplab replay: computes a recorded session again and compares the hashes.
std::unique_ptr<Command> replay_command();

}  // namespace steplab
