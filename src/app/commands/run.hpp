#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab run SCENE TIME [--every K] [--out ...] [--series ...] [--summary ...]`: the run as numbers.
std::unique_ptr<Command> run_command();

}  // namespace steplab
