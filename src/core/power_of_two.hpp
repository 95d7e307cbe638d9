#pragma once

#include "core/lanes.hpp"
#include "core/number.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace steplab {

/// A quotient before its division: a caller that divides anyway then needs only one division.
template <class N>
struct Fraction {
    N numerator, denominator;
};

namespace detail {

/// 2^f = (q + f p) / (q - f p) for |f| <= 1/2, with polynomials p and q of f^2: f p / q is tanh(f ln(2) / 2),
/// interpolated at the Chebyshev nodes of f^2.
template <class T>
struct PowerOfTwoTraits;

template <>
struct PowerOfTwoTraits<float> : ExponentialTraits<float> {
    static constexpr float p_last = 0x1.d8ae82p-5f, q_last = 0x1.4d1738p+4f;
    static constexpr std::array p{0x1.cdc302p+2f};
    static constexpr std::array<float, 0> q{};  // errors below 6e-9
};

template <>
struct PowerOfTwoTraits<double> : ExponentialTraits<double> {
    static constexpr double p_last = 0x1.7a60ee97ff5f1p-6, q_last = 0x1.d25b024e90d89p+7;
    static constexpr std::array p{0x1.7a771689fae49p+10, 0x1.433a0b00c025ep+4};
    static constexpr std::array q{0x1.110142bebb5f8p+12};  // errors below 2e-17
};

/// 2^n, where adding a shift has moved n into the last bits of a number.
template <std::floating_point T>
T two_to_the(T shifted) {
    using Traits = ExponentialTraits<T>;
    using Bits = typename Traits::Bits;
    constexpr Bits bias = Traits::bias - __builtin_bit_cast(Bits, Traits::shift);
    return __builtin_bit_cast(T, (__builtin_bit_cast(Bits, shifted) + bias) << Traits::mantissa);
}
template <class T, std::size_t Count>
[[gnu::always_inline]] inline RegisterLanes<T, Count> two_to_the(const RegisterLanes<T, Count>& shifted) {
    using Traits = ExponentialTraits<T>;
    using Lanes = RegisterLanes<T, Count>;
    constexpr auto bias = Traits::bias - __builtin_bit_cast(typename Traits::Bits, Traits::shift);
    auto registers = shifted.registers();
    for (auto& lanes : registers) {
        const auto bits = (__builtin_bit_cast(typename Lanes::Bits, lanes) + bias) << Traits::mantissa;
        lanes = __builtin_bit_cast(typename Lanes::Register, bits);
    }
    return Lanes(registers);
}

/// c[0] + c[1] x + ... + c[Count - 1] x^(Count - 1) + `rest` x^Count by Horner's scheme.
template <class N, class T, std::size_t Count>
[[gnu::always_inline]] inline N polynomial(const std::array<T, Count>& c, const N& x, N rest) {
    for (std::size_t k = Count; k > 0; --k) rest = N(c[k - 1]) + rest * x;
    return rest;
}

template <class T, class N>
[[gnu::always_inline]] inline Fraction<N> power_of_two_of(const N& x) {
    using Traits = PowerOfTwoTraits<T>;
    const N lowest(T(-Traits::bias)), highest(T(Traits::bias + 1)), shift(Traits::shift);
    const N inside = where(x < lowest, lowest, x);  // x above the range is handled below, off this path
    const N shifted = inside + shift;
    const N f = inside - (shifted - shift), f2 = f * f;
    const N odd = f * polynomial(Traits::p, f2, N(Traits::p_last));
    const N even = polynomial(Traits::q, f2, f2 + N(Traits::q_last));
    const N power = where(x > highest, N(std::numeric_limits<T>::infinity()), two_to_the(shifted));
    return {(even + odd) * power, even - odd};
}

template <class T>
concept InRegisters = std::is_same_v<T, float> || std::is_same_v<T, double>;

}  // namespace detail

/// 2^x as a fraction whose quotient is within 2.5 ulp, bit-identical on every system. x is split without rounding; if x
/// is itself a rounded product, an exponent times the logarithm of a base, that rounding adds |x| ln 2 / 2 ulp. Below
/// the range of normal numbers the result is 0. It becomes infinite 11 binary digits below the end of the range (float:
/// 5), and is not a number for infinite x.
template <detail::InRegisters T>
Fraction<T> power_of_two(T x) {
    return detail::power_of_two_of<T>(x);
}
template <class T, std::size_t Count>
[[gnu::always_inline]] inline Fraction<RegisterLanes<T, Count>> power_of_two(const RegisterLanes<T, Count>& x) {
    return detail::power_of_two_of<T>(x);
}

/// Numbers with such powers.
template <class N>
concept WithPowersOfTwo = requires(const N& x) {
    power_of_two(x);
};

}  // namespace steplab
