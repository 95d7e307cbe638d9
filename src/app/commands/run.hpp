#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab run SCENE TIME [--every K] [--out ...] [--series ...] [--summary ...]`: a run and its results.
std::unique_ptr<Command> run_command();

}  // namespace steplab
