#pragma once

#include "app/commands/command.hpp"

#include <memory>

namespace steplab {

/// `steplab convert FILE [--out FILE|-] [--format ...] [--columns ...]`: the frames of a file in another format.
std::unique_ptr<Command> convert_command();

}  // namespace steplab
