#pragma once

#include "core/processor.hpp"

#include <span>
#include <string_view>

namespace steplab {

/// The instruction sets that this program was compiled for and this processor supports, slowest first.
std::span<const Instructions> instructions_here();
/// The fastest of them. Throws UsageError if there is none: the program was built only for another processor.
Instructions fastest_instructions();

std::string_view id(Instructions instructions);
/// The instruction set with this id among instructions_here(). Throws UsageError naming them.
Instructions parse_instructions(std::string_view id);

}  // namespace steplab
