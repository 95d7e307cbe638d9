#pragma once

#include "core/processor.hpp"

#include <span>
#include <string_view>

namespace steplab {

/// Those that this program was compiled for and this processor has, the slowest first.
std::span<const Instructions> instructions_here();
/// The fastest of them. Throws UsageError if there is none: the program was built for the instruction set of another
/// processor alone.
Instructions fastest_instructions();

std::string_view id(Instructions instructions);
/// Of those here. Throws UsageError that names them.
Instructions parse_instructions(std::string_view id);

}  // namespace steplab
