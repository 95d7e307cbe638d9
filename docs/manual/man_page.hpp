#pragma once

#include "described_command.hpp"

#include <span>
#include <string>

namespace steplab::manual {

/// steplab(1): the commands. In the language of man(7).
std::string man_page(std::span<const DescribedCommand> commands);
/// steplab-run(1) and the like. `program`: "steplab run", or "steplab-view" that takes the options of `steplab view`.
std::string man_page(const DescribedCommand& command, const std::string& program);

/// A text as man(7) shows it unchanged.
std::string escaped(const std::string& text);

}  // namespace steplab::manual
