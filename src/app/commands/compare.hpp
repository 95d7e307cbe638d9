#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// steplab compare: runs of one scene against its motion over time, as CSV.
std::unique_ptr<Command> compare_command();

}  // namespace steplab
