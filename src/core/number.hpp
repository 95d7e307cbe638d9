#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace steplab {

// What the formulas of forces ask of a number type beside + - * /: square_root, exponential, where, value_of. Types
// with parts of their own (dual numbers, lanes, power series) overload these beside their class.

template <std::floating_point T>
T square_root(T x) {
    return std::sqrt(x);
}

/// The number without derivatives or other parts.
template <std::floating_point T>
T value_of(T number) {
    return number;
}

/// `then` where the condition holds, else `otherwise`; both are computed.
template <std::floating_point T>
T where(bool condition, T then, T otherwise) {
    return condition ? then : otherwise;
}

namespace detail {

/// 1 / k! for k = 0 .. Degree.
template <class T, std::size_t Degree>
inline constexpr auto inverse_factorials = [] {
    std::array<T, Degree + 1> values{};
    long double factorial = 1;
    for (std::size_t k = 0; k <= Degree; ++k) {
        if (k > 0) factorial *= static_cast<long double>(k);
        values[k] = static_cast<T>(1 / factorial);
    }
    return values;
}();

/// How exponential() takes a number type apart. ln 2 is split so that n * ln2_high is exact for every exponent n.
template <class T>
struct ExponentialTraits;

template <>
struct ExponentialTraits<float> {
    using Bits = std::int32_t;
    static constexpr std::size_t degree = 7;  // remainder (ln2/2)^8 / 8! = 5e-9
    static constexpr float ln2_high = 0x1.62ep-1f, ln2_low = 0x1.0bfbe8p-15f;
    static constexpr float shift = 0x1.8p23f;  // adding it rounds to a whole number
    static constexpr float lowest = -87.0f, highest = 88.0f;
    static constexpr int mantissa = 23, bias = 127;
};

template <>
struct ExponentialTraits<double> {
    using Bits = std::int64_t;
    static constexpr std::size_t degree = 13;  // remainder (ln2/2)^14 / 14! = 4e-18
    static constexpr double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;
    static constexpr double shift = 0x1.8p52;
    static constexpr double lowest = -708.0, highest = 709.0;
    static constexpr int mantissa = 52, bias = 1023;
};

/// e^r for |r| <= ln(2)/2: Taylor polynomial in Horner's form.
template <std::size_t Degree, class T>
T exponential_polynomial(T r) {
    T sum = inverse_factorials<T, Degree>[Degree];
    for (std::size_t k = Degree; k-- > 0;) sum = sum * r + inverse_factorials<T, Degree>[k];
    return sum;
}

}  // namespace detail

/// e^x, within 1.5 ulp, the same bits on every system (libm's differ) and in plain code that vectorises.
/// Below the range of normal numbers it is 0, above it infinite.
template <std::floating_point T>
T exponential(T x) {
    using Traits = detail::ExponentialTraits<T>;
    using Bits = typename Traits::Bits;
    const T inside = where(x > Traits::lowest, where(x < Traits::highest, x, Traits::highest), Traits::lowest);
    const T shifted = inside * static_cast<T>(1.4426950408889634074) + Traits::shift;
    const T n = shifted - Traits::shift;
    const T r = (inside - n * Traits::ln2_high) - n * Traits::ln2_low;
    const Bits exponent = __builtin_bit_cast(Bits, shifted) - __builtin_bit_cast(Bits, Traits::shift);
    const T power = __builtin_bit_cast(T, static_cast<Bits>((exponent + Traits::bias) << Traits::mantissa));
    const T result = detail::exponential_polynomial<Traits::degree>(r) * power;
    const T above = where(x > Traits::highest, std::numeric_limits<T>::infinity(), result);
    return where(x < Traits::lowest, T(0), where(std::isnan(x), x, above));
}

/// For references: libm's, whose last bits no golden result depends on.
inline long double exponential(long double x) { return std::exp(x); }

}  // namespace steplab
