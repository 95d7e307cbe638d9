#pragma once

namespace steplab {

/// The instruction sets that methods are compiled for. All of them compute the same bits.
enum class Instructions {
    baseline,  ///< supported by every processor of the architecture
    avx2,      ///< of x86-64: registers of 32 bytes
    avx512     ///< of x86-64: registers of 64 bytes
};

/// True if this processor supports them: the features are those of the flags in cmake/SteplabTargets.cmake.
inline bool processor_has(Instructions instructions) {
#if defined(__x86_64__)
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    if (instructions == Instructions::avx2) return avx2;
    if (instructions == Instructions::avx512)
        return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
               __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
#endif
    return instructions == Instructions::baseline;
}

}  // namespace steplab
