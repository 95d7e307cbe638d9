#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab bench [--method ID] [--json]`: the time per step on this machine and what limits it.
std::unique_ptr<Command> bench_command();

}  // namespace steplab
