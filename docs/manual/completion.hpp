#pragma once

#include "described_command.hpp"

#include <span>
#include <string>

namespace steplab::manual {

/// What bash, and zsh, source to complete the command line: commands, options, and values that are names of models,
/// methods, shipped scenes, words or files.
std::string bash_completion(std::span<const DescribedCommand> commands);
std::string zsh_completion(std::span<const DescribedCommand> commands);

}  // namespace steplab::manual
