#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace steplab {

// What the force formulas require of a number type besides + - * /: square_root, exponential, where, value_of. Types
// with further components (dual numbers, lanes, power series) overload these next to their class.

template <std::floating_point T>
T square_root(T x) {
    return std::sqrt(x);
}

/// The number without derivatives or other components.
template <std::floating_point T>
T value_of(T number) {
    return number;
}

/// `then` where the condition holds, else `otherwise`; both are computed.
template <std::floating_point T>
T where(bool condition, T then, T otherwise) {
    return condition ? then : otherwise;
}

/// The absolute value of a number, or of each lane.
template <class N>
N magnitude(N x) {
    return where(x < N(0), N(0) - x, x);
}

namespace detail {

/// The constants of exponential() for each number type. ln 2 is split so that n * ln2_high is exact for every exponent
/// n.
template <class T>
struct ExponentialTraits;

template <>
struct ExponentialTraits<float> {
    using Bits = std::int32_t;
    static constexpr std::size_t degree = 6;  // of a polynomial with errors below 2e-9
    static constexpr float ln2_high = 0x1.62ep-1f, ln2_low = 0x1.0bfbe8p-15f;
    static constexpr float shift = 0x1.8p23f;  // adding it rounds to an integer
    static constexpr int mantissa = 23, bias = 127;
};

template <>
struct ExponentialTraits<double> {
    using Bits = std::int64_t;
    static constexpr std::size_t degree = 11;  // of a polynomial with errors below 4e-18
    static constexpr double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;
    static constexpr double shift = 0x1.8p52;
    static constexpr int mantissa = 52, bias = 1023;
};

template <>
struct ExponentialTraits<long double> {
    static constexpr std::size_t degree = 13;  // of a polynomial with errors below 1e-21
    static constexpr long double ln2_high = 0x1.62e42fefa3p-1L, ln2_low = 0x0.9ef35793c7673007e5ed5e81e68p-41L;
};

/// Coefficients of a polynomial that is e^r for |r| <= ln(2)/2: the Taylor series with six more terms, whose highest
/// powers are replaced one by one by means of Chebyshev polynomials (economisation of power series; Lanczos, Applied
/// Analysis (1956), VII). The first two coefficients are 1.
template <class T>
inline constexpr auto exponential_coefficients = [] {
    constexpr std::size_t degree = ExponentialTraits<T>::degree, most = degree + 6;
    constexpr long double reach2 = 0.25L * 0.48045301391820142467L;  // (ln(2)/2)^2
    std::array<long double, most + 1> series{1};
    for (std::size_t k = 1; k <= most; ++k) series[k] = series[k - 1] / static_cast<long double>(k);
    for (std::size_t n = most; n > degree; --n) {
        long double term = series[n];
        for (std::size_t m = 0; 2 * m + 2 <= n; ++m) {
            const std::size_t power = n - 2 * m;
            term *= -reach2 * static_cast<long double>(power * (power - 1)) /
                    static_cast<long double>(4 * (m + 1) * (n - m - 1));
            series[power - 2] -= term;
        }
    }
    std::array<T, degree + 1> coefficients{};
    for (std::size_t k = 0; k <= degree; ++k) coefficients[k] = static_cast<T>(series[k]);
    return coefficients;
}();

/// c[First] + c[First + 1] r + ... with Count coefficients, in halves that do not depend on each other (Estrin's
/// scheme). `powers` are r, r^2, r^4, ...
template <class T, std::size_t First, std::size_t Count, class N, std::size_t M>
[[gnu::always_inline]] inline N exponential_terms(const std::array<N, M>& powers) {
    if constexpr (Count == 1) {
        return N(exponential_coefficients<T>[First]);
    } else {
        constexpr std::size_t doublings = std::bit_width(Count - 1) - 1, half = std::size_t(1) << doublings;
        return exponential_terms<T, First, half>(powers) +
               exponential_terms<T, First + half, Count - half>(powers) * powers[doublings];
    }
}

/// e^r for |r| <= ln(2)/2.
template <class T, class N>
[[gnu::always_inline]] inline N exponential_polynomial(N r) {
    const N r2 = r * r, r4 = r2 * r2, r8 = r4 * r4;
    const N rest = exponential_terms<T, 2, ExponentialTraits<T>::degree - 1>(std::array<N, 4>{r, r2, r4, r8});
    return N(T(1)) + (r + rest * r2);
}

/// exponential() for numbers or lanes N of type T, whose bits are integers of type Bits. e^x is 2^n times the
/// polynomial; for the smallest and the largest n, the bits of 2^n are those of 0 and of infinity.
template <class T, class Bits, class N>
[[gnu::always_inline]] inline N exponential_of(N x) {
    using Traits = ExponentialTraits<T>;
    constexpr T ln2 = static_cast<T>(0.69314718055994530942L);
    const N lowest(-Traits::bias * ln2), highest((Traits::bias + 1) * ln2), shift(Traits::shift);
    const N inside = where(x < lowest, lowest, where(x > highest, highest, x));
    const N shifted = inside * N(1 / ln2) + shift;
    const N n = shifted - shift;
    const N r = (inside - n * N(Traits::ln2_high)) - n * N(Traits::ln2_low);
    const auto bias = Traits::bias - __builtin_bit_cast(typename Traits::Bits, Traits::shift);
    const N power = __builtin_bit_cast(N, (__builtin_bit_cast(Bits, shifted) + bias) << Traits::mantissa);
    return exponential_polynomial<T>(r) * power;
}

}  // namespace detail

/// e^x within 1.5 ulp, bit-identical on every system (libm's results differ), in plain code that vectorises. The range
/// is -1022.5 to 1023.5 ln 2 for double, -126.5 to 127.5 ln 2 for float; below it the result is 0, above it infinite.
template <std::floating_point T>
T exponential(T x) {
    return detail::exponential_of<T, typename detail::ExponentialTraits<T>::Bits>(x);
}

/// The same for reference solutions, within 1.5 ulp of the 64-bit significand of x86-64. libm uses x87 instructions,
/// whose last bits differ between manufacturers. Below the range of normal numbers the result is subnormal.
inline long double exponential(long double x) {
    using Traits = detail::ExponentialTraits<long double>;
    constexpr long double beyond = 12000;  // the range of e^x, and of n
    if (!(std::abs(x) < beyond)) return x < 0 ? 0 : x > 0 ? std::numeric_limits<long double>::infinity() : x;
    const long double n = std::rint(x * 1.4426950408889634073599L);
    const long double r = (x - n * Traits::ln2_high) - n * Traits::ln2_low;
    return std::ldexp(detail::exponential_polynomial<long double>(r), static_cast<int>(n));
}

}  // namespace steplab
