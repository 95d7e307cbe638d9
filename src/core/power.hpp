#pragma once

#include "core/number.hpp"

#include <cstdint>
#include <limits>

namespace steplab {

/// ln x for normal x > 0, within 2 ulp, bit-identical on every system (libm's results differ): x = 2^n m with m near 1,
/// and ln m = 2 artanh((m - 1) / (m + 1)) from its series.
inline double logarithm(double x) {
    constexpr std::int64_t half_root_of_2 = 0x3FE6A09E667F3BCD;  // the bits of sqrt(1/2)
    const std::int64_t bits = __builtin_bit_cast(std::int64_t, x);
    const std::int64_t n = (bits - half_root_of_2) >> 52;
    const double m = __builtin_bit_cast(double, bits - (n << 52));
    const double s = (m - 1) / (m + 1), square = s * s;
    double sum = 0;
    for (int k = 23; k >= 1; k -= 2) sum = sum * square + 1.0 / k;  // remainder 0.172^25 / 25 = 3e-21
    using Traits = detail::ExponentialTraits<double>;
    const double high = static_cast<double>(n) * Traits::ln2_high, low = static_cast<double>(n) * Traits::ln2_low;
    return high + (2 * s * sum + low);
}

/// base^exponent for base >= 0, bit-identical on every system. A base outside the range of normal numbers is replaced
/// by the nearest normal number.
inline double power(double base, double exponent) {
    constexpr double least = std::numeric_limits<double>::min(), most = std::numeric_limits<double>::max();
    const double inside = base > least ? (base < most ? base : most) : least;
    return exponential(exponent * logarithm(inside));
}

}  // namespace steplab
