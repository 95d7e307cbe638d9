#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <cstdint>

namespace steplab {

/// During its lifetime the thread treats subnormal numbers as zero, as operands and as results. This is part of the
/// definition of a run's bits, and avoids subnormals being a hundred times slower on many processors.
class FlushSubnormals {
public:
    FlushSubnormals() : before_(control()) { control(before_ | flush_bits); }
    ~FlushSubnormals() { control(before_); }
    FlushSubnormals(const FlushSubnormals&) = delete;
    FlushSubnormals& operator=(const FlushSubnormals&) = delete;

private:
#if defined(__SSE2__)
    static constexpr std::uint64_t flush_bits = 0x8040;  // FTZ and DAZ of MXCSR
    static std::uint64_t control() { return _mm_getcsr(); }
    static void control(std::uint64_t bits) { _mm_setcsr(static_cast<unsigned>(bits)); }
#elif defined(__aarch64__)
    static constexpr std::uint64_t flush_bits = std::uint64_t{1} << 24;  // FZ of FPCR
    static std::uint64_t control() {
        std::uint64_t bits;
        asm volatile("mrs %0, fpcr" : "=r"(bits));
        return bits;
    }
    static void control(std::uint64_t bits) { asm volatile("msr fpcr, %0" : : "r"(bits)); }
#else
#error "flushing of subnormal numbers is not implemented for this processor"
#endif

    std::uint64_t before_;
};

}  // namespace steplab
