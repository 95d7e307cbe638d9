#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab crosscheck SCENE TIME`: the same run by LAMMPS, and whether both agree.
std::unique_ptr<Command> crosscheck_command();

}  // namespace steplab
