#pragma once

#include <span>
#include <string_view>

namespace steplab {

/// The instruction sets that methods are compiled for. All of them compute the same bits.
enum class Instructions {
    baseline,  ///< what every processor of the kind has
    avx2,      ///< of x86-64: registers of 32 bytes
    avx512     ///< of x86-64: registers of 64 bytes
};

/// Those that this program was compiled for and this processor has, the slowest first.
std::span<const Instructions> instructions_here();
/// The fastest of them.
Instructions fastest_instructions();

std::string_view id(Instructions instructions);
/// Of those here. Throws UsageError that names them.
Instructions parse_instructions(std::string_view id);

}  // namespace steplab
