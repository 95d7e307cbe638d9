#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab report`: the time that every method takes to a given error on every scene, as a table and a page.
std::unique_ptr<Command> report_command();

}  // namespace steplab
