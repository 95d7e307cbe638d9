#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab bench [--method ID] [--json]`: how fast this machine steps, and what bounds it.
std::unique_ptr<Command> bench_command();

}  // namespace steplab
