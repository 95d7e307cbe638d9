#pragma once

#include "app/commands/command.hpp"

#include <memory>
#include <string>
#include <vector>

namespace steplab {

/// All sub-commands in the order of the help. `arguments`: those after the command's name, for commands that pass them
/// to another program.
std::vector<std::unique_ptr<Command>> commands(const std::vector<std::string>& arguments);

/// The program `steplab`: finds the command, parses its options and runs it. Returns the exit code.
int run_steplab(std::vector<std::string> arguments);

}  // namespace steplab
