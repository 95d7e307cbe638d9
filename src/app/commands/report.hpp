#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab report`: speed against error of all methods on all scenes, as a table and a page.
std::unique_ptr<Command> report_command();

}  // namespace steplab
