#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab cluster SCENE TIME --ranks N`: the run computed by LAMMPS, its results as those of `run`.
std::unique_ptr<Command> cluster_command();

}  // namespace steplab
