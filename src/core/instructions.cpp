#include "core/instructions.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#ifndef STEPLAB_INSTRUCTIONS
#define STEPLAB_INSTRUCTIONS Instructions::baseline
#endif

namespace steplab {

namespace {

// The features are those of the flags that cmake/SteplabTargets.cmake compiles with.
bool processor_has(Instructions instructions) {
#if defined(__x86_64__)
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    if (instructions == Instructions::avx2) return avx2;
    if (instructions == Instructions::avx512)
        return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
               __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
#endif
    return instructions == Instructions::baseline;
}

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

Instructions fastest_instructions() { return instructions_here().back(); }

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
    throw UsageError(fmt::format("unknown instruction set '{}' (this processor and program have {})", text, known));
}

}  // namespace steplab
