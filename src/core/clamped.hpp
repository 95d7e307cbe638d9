#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace steplab {

/// The whole number at or below x, at least `low` and at most `high` (low <= high, which doubles hold exactly); `low`
/// for what is not a number. The way from numbers that a run or a camera made to indices and counts: a plain cast of
/// what is out of range is undefined.
template <class Integer = int>
Integer clamped_floor(double x, std::type_identity_t<Integer> low, std::type_identity_t<Integer> high) {
    if (!(x > static_cast<double>(low))) return low;
    return x < static_cast<double>(high) ? static_cast<Integer>(std::floor(x)) : high;
}

/// So many seconds as a duration of the clock: none of what is not above 0, and at most `most` (below 1e9), so that any
/// time can be added to it.
inline std::chrono::steady_clock::duration clamped_seconds(double seconds, double most) {
    using Clock = std::chrono::steady_clock;
    const std::chrono::duration<double, Clock::period> ticks = std::chrono::duration<double>(seconds);
    const auto bound = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(most));
    return Clock::duration(clamped_floor<Clock::rep>(ticks.count(), 0, bound.count()));
}

}  // namespace steplab
