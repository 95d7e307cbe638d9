#include "core/instructions.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#ifndef STEPLAB_INSTRUCTIONS
#define STEPLAB_INSTRUCTIONS Instructions::baseline
#endif

namespace steplab {

namespace {

std::vector<Instructions> found() {
    std::vector<Instructions> here;
    for (const Instructions instructions : {STEPLAB_INSTRUCTIONS}) {
        if (processor_has(instructions)) here.push_back(instructions);
    }
    return here;
}

}  // namespace

std::span<const Instructions> instructions_here() {
    static const std::vector<Instructions> here = found();
    return here;
}

Instructions fastest_instructions() {
    if (instructions_here().empty())
        throw UsageError(
            "this steplab was built only for the processor of another machine; build it on this machine, or for all "
            "processors:  cmake --preset release && cmake --build --preset release");
    return instructions_here().back();
}

std::string_view id(Instructions instructions) {
    constexpr std::string_view ids[] = {"baseline", "avx2", "avx512"};
    return ids[static_cast<std::size_t>(instructions)];
}

Instructions parse_instructions(std::string_view text) {
    std::string known;
    for (const Instructions instructions : instructions_here()) {
        if (id(instructions) == text) return instructions;
        known += (known.empty() ? "" : ", ") + std::string(id(instructions));
    }
    throw UsageError(
        fmt::format("unknown instruction set '{}' (this processor and program have {})", shown(text), known));
}

}  // namespace steplab
