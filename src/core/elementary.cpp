#include "core/elementary.hpp"

#include "core/double_double.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace steplab {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// c[0] + c[1] x + ... (Horner's scheme).
template <std::size_t Count>
double polynomial(const std::array<double, Count>& coefficients, double x) {
    double sum = 0;
    for (std::size_t k = Count; k-- > 0;) sum = sum * x + coefficients[k];
    return sum;
}

/// x = 2^exponent fraction, the fraction in [sqrt(1/2), sqrt(2)); x positive and finite.
struct Scaled {
    double exponent, fraction;
};
Scaled scaled(double x) {
    int exponent = 0;
    const double half = std::frexp(x, &exponent);  // exact, of subnormal numbers too
    constexpr double root = 0.70710678118654752440;
    if (half < root) return {exponent - 1.0, 2 * half};
    return {static_cast<double>(exponent), half};
}

/// 1/5 + x/7 + x^2/9 + ...: of artanh(s) = s + s^3/3 + s^5 (...), x = s^2 <= 0.0295; the next term is 4e-19.
constexpr auto artanh_coefficients = [] {
    std::array<double, 11> coefficients{};
    for (std::size_t k = 0; k < coefficients.size(); ++k) coefficients[k] = 1.0 / static_cast<double>(2 * k + 5);
    return coefficients;
}();

/// ln x of a positive finite number, relative error about 2^-68: ln x = n ln 2 + 2 artanh((m - 1) / (m + 1)).
DoubleDouble precise_logarithm(double x) {
    const Scaled parts = scaled(x);
    const DoubleDouble s = DoubleDouble(parts.fraction - 1) / sum_of(parts.fraction, 1.0);
    const DoubleDouble square = s * s;
    constexpr DoubleDouble third{0x1.5555555555555p-2, 0x1.5555555555555p-56};
    const DoubleDouble rest = third + DoubleDouble(square.high * polynomial(artanh_coefficients, square.high));
    const DoubleDouble artanh = s + s * (square * rest);
    constexpr double ln2_high = 0x1.62e42fee00000p-1;  // times n exactly
    constexpr double ln2_low = 0x1.a39ef35793c76p-33;
    return (DoubleDouble(parts.exponent * ln2_high) + product_of(parts.exponent, ln2_low)) + artanh * 2.0;
}

/// x - quadrant pi / 2, at most pi / 4 in size.
struct Reduced {
    unsigned quadrant;
    DoubleDouble angle;
};

/// Cody, Waite, Software Manual for the Elementary Functions (1980): the first parts of pi / 2 have 33 bits, so that
/// their products with numbers below 2^20 are exact.
Reduced reduced_in_parts(double x) {
    constexpr double part_1 = 0x1.921fb544p+0, part_2 = 0x1.0b4611a6p-34, part_3 = 0x1.3198a2ep-69;
    constexpr double part_4 = 0x1.b839a252049c1p-104, inverse = 0.63661977236758134308;
    const double n = std::rint(x * inverse);
    DoubleDouble angle(x - n * part_1);
    angle = ((angle - DoubleDouble(n * part_2)) - DoubleDouble(n * part_3)) - product_of(n, part_4);
    return {static_cast<unsigned>(static_cast<std::int64_t>(n)) & 3U, angle};
}

/// 2 / pi in units of 2^-64, 2^-128, ..., after 64 zeros.
constexpr std::array<std::uint64_t, 21> two_over_pi{
    0,
    0xA2F9836E4E441529,
    0xFC2757D1F534DDC0,
    0xDB6295993C439041,
    0xFE5163ABDEBBC561,
    0xB7246E3A424DD2E0,
    0x06492EEA09D1921C,
    0xFE1DEB1CB129A73E,
    0xE88235F52EBB4484,
    0xE99C7026B45F7E41,
    0x3991D639835339F4,
    0x9C845F8BBDF9283B,
    0x1FF897FFDE05980F,
    0xEF2F118B5A0A6D1F,
    0x6D367ECF27CB09B7,
    0x4F463F669E5FEA2D,
    0x7527BAC7EBE5F17B,
    0x3D0739F78A5292EA,
    0x6BFB5FB11F8D5D08,
    0x56033046FC7B6BAB,
    0xF0CFBC209AF4361D,
};

/// 64 bits from a bit on, the first one 0.
std::uint64_t bits_of_two_over_pi(std::size_t first) {
    const std::size_t word = first / 64, shift = first % 64;
    if (shift == 0) return two_over_pi[word];
    return two_over_pi[word] << shift | two_over_pi[word + 1] >> (64 - shift);
}

/// Payne, Hanek, SIGNUM Newsletter 18 (1983) 19: of 2 / pi those 192 bits that matter, for 2^20 <= |x|.
Reduced reduced_by_bits(double x) {
    int exponent = 0;
    const auto whole = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(x), &exponent), 53));
    exponent -= 53;  // |x| = whole 2^exponent
    // Bits above these count whole turns: the first has the weight 2^(2 - 1 - exponent), the table's first 2^63.
    const int first_bit = 62 + exponent;
    const auto first = static_cast<std::size_t>(first_bit);
    __extension__ using Wide = unsigned __int128;
    const Wide low = Wide(whole) * bits_of_two_over_pi(first + 128);
    const Wide middle = Wide(whole) * bits_of_two_over_pi(first + 64) + static_cast<std::uint64_t>(low >> 64);
    const std::uint64_t high = whole * bits_of_two_over_pi(first) + static_cast<std::uint64_t>(middle >> 64);
    // high, middle, low: the quarter turns in units of 2^-190, modulo 4.
    const bool up = (high >> 61 & 1) != 0;  // rounded to the nearest whole one
    const auto quadrant = static_cast<unsigned>(high >> 62) + (up ? 1U : 0U);
    const auto top = static_cast<std::int64_t>(high << 2 | static_cast<std::uint64_t>(middle) >> 62);
    const auto chunk = [](std::uint64_t bits, int weight) { return std::ldexp(static_cast<double>(bits), weight); };
    const std::uint64_t next = static_cast<std::uint64_t>(middle) << 2 | static_cast<std::uint64_t>(low) >> 62;
    const std::uint64_t last = static_cast<std::uint64_t>(low) << 2;
    DoubleDouble turns(std::ldexp(static_cast<double>(top >> 32), -32));
    turns = turns + DoubleDouble(chunk(static_cast<std::uint64_t>(top) & 0xFFFFFFFFU, -64));
    turns = turns + DoubleDouble(chunk(next >> 32, -96)) + DoubleDouble(chunk(next & 0xFFFFFFFFU, -128));
    turns = turns + DoubleDouble(chunk(last >> 32, -160));
    constexpr DoubleDouble half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
    const DoubleDouble angle = turns * half_pi;
    if (x < 0) return {(4U - quadrant) & 3U, DoubleDouble(0) - angle};
    return {quadrant & 3U, angle};
}

Reduced reduced(double x) { return std::abs(x) < 0x1p20 ? reduced_in_parts(x) : reduced_by_bits(x); }

/// (-1)^k / n! for n = First + 2 k: the series of sine and cosine, at most pi / 4 from 0 as accurate as double.
template <std::size_t First, std::size_t Count>
constexpr auto circle_coefficients = [] {
    std::array<double, Count> coefficients{};
    long double factorial = 1;
    for (std::size_t n = 2; n <= First; ++n) factorial *= static_cast<long double>(n);
    for (std::size_t k = 0; k < Count; ++k) {
        coefficients[k] = static_cast<double>((First / 2 + k) % 2 == 0 ? 1 / factorial : -1 / factorial);
        const auto n = static_cast<long double>(First + 2 * k);
        factorial *= (n + 1) * (n + 2);
    }
    return coefficients;
}();

DoubleDouble sine_of(DoubleDouble r) {
    const double square = r.high * r.high;
    const double rest = square * r.high * polynomial(circle_coefficients<3, 8>, square);
    return sum_of(r.high, rest + r.low * (1 - square / 2));
}

DoubleDouble cosine_of(DoubleDouble r) {
    const double square = r.high * r.high, half = square / 2, first = 1 - half;
    const double rest = square * square * polynomial(circle_coefficients<4, 8>, square);
    return sum_of(first, ((1 - first) - half) + (rest - r.high * r.low));
}

/// The series tanh x = x + t[0] x^3 + t[1] x^5 + ..., from sinh = tanh cosh; for |x| <= 0.55 the next term is 1e-18.
constexpr auto tanh_coefficients = [] {
    constexpr std::size_t terms = 20;
    std::array<long double, terms> tanh{};
    std::array<long double, 2 * terms> all{1};
    for (std::size_t n = 1; n < 2 * terms; ++n) all[n] = all[n - 1] / static_cast<long double>(n);
    for (std::size_t k = 0; k < terms; ++k) {
        tanh[k] = all[2 * k + 1];
        for (std::size_t j = 0; j < k; ++j) tanh[k] -= tanh[j] * all[2 * (k - j)];
    }
    std::array<double, terms - 1> coefficients{};
    for (std::size_t k = 1; k < terms; ++k) coefficients[k - 1] = static_cast<double>(tanh[k]);
    return coefficients;
}();

bool is_odd(double x) { return is_whole(x) && std::abs(x) < 0x1p53 && std::fmod(x, 2) != 0; }

/// base^exponent for a positive finite base.
double positive_power(double base, double exponent) {
    constexpr double beyond = 0x1p70;  // any base but 1 has left the range long before
    const DoubleDouble logarithm = precise_logarithm(base);
    if (std::abs(exponent) > beyond) return base == 1 ? 1 : (base > 1) == (exponent > 0) ? endless : 0;
    const double coarse = exponent * logarithm.high;
    if (!(std::abs(coarse) < 1024)) return exponential(coarse);
    const DoubleDouble power = logarithm * exponent;
    const double value = exponential(power.high);
    return value + value * power.low;
}

}  // namespace

double natural_logarithm(double x) {
    if (x > 0 && x < endless) return precise_logarithm(x).high;
    return x == 0 ? -endless : x < 0 ? not_a_number : x;
}

double sine(double x) {
    if (!std::isfinite(x)) return not_a_number;
    if (std::abs(x) < 0x1p-27) return x;  // also keeps -0
    const Reduced r = reduced(x);
    const double value = (r.quadrant % 2 == 0 ? sine_of(r.angle) : cosine_of(r.angle)).high;
    return r.quadrant < 2 ? value : -value;
}

double cosine(double x) {
    if (!std::isfinite(x)) return not_a_number;
    const Reduced r = reduced(x);
    const double value = (r.quadrant % 2 == 0 ? cosine_of(r.angle) : sine_of(r.angle)).high;
    return r.quadrant == 0 || r.quadrant == 3 ? value : -value;
}

double tangent(double x) {
    if (!std::isfinite(x)) return not_a_number;
    if (std::abs(x) < 0x1p-27) return x;
    const Reduced r = reduced(x);
    const DoubleDouble sine = sine_of(r.angle), cosine = cosine_of(r.angle);
    return r.quadrant % 2 == 0 ? (sine / cosine).high : -(cosine / sine).high;
}

double hyperbolic_tangent(double x) {
    const double size = std::abs(x), square = x * x;
    if (size < 0x1p-27) return x;
    if (size <= 0.55) return x + x * square * polynomial(tanh_coefficients, square);
    const double value = size < 20 ? 1 - 2 / (exponential(2 * size) + 1) : size >= 20 ? 1 : not_a_number;
    return x < 0 ? -value : value;
}

double general_power(double base, double exponent) {
    if (exponent == 0 || base == 1) return 1;
    if (std::isnan(base) || std::isnan(exponent)) return not_a_number;
    if (base < 0 && std::isfinite(exponent) && !is_whole(exponent)) return not_a_number;
    const double size = std::abs(base), sign = base < 0 && is_odd(exponent) ? -1 : 1;
    if (size == 1 && !std::isfinite(exponent)) return 1;
    if (size == 0 || size == endless) return sign * ((size == 0) == (exponent > 0) ? 0 : endless);
    return sign * positive_power(size, exponent);
}

}  // namespace steplab
