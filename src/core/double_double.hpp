#pragma once

namespace steplab {

/// The unevaluated sum of two doubles, |low| at most half an ulp of high: about 105 bits (Dekker, Numerische Mathematik
/// 18 (1971) 224). Numbers between about 1e-280 and 1e290 in size, and 0.
struct DoubleDouble {
    double high = 0, low = 0;

    constexpr DoubleDouble() = default;
    constexpr explicit DoubleDouble(double number) : high(number) {}
    constexpr DoubleDouble(double upper, double lower) : high(upper), low(lower) {}
};

/// a + b exactly (Knuth, The Art of Computer Programming 2, 4.2.2).
constexpr DoubleDouble sum_of(double a, double b) {
    const double sum = a + b, from_b = sum - a;
    return {sum, (a - (sum - from_b)) + (b - from_b)};
}

/// a b exactly, of factors split in halves (Dekker 1971, section 5).
constexpr DoubleDouble product_of(double a, double b) {
    const auto upper = [](double x) {
        const double large = 134217729.0 * x;  // 2^27 + 1
        return large - (large - x);
    };
    const double product = a * b, a1 = upper(a), a2 = a - a1, b1 = upper(b), b2 = b - b1;
    return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble sum = sum_of(a.high, b.high);
    return sum_of(sum.high, sum.low + (a.low + b.low));
}
constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + DoubleDouble{-b.high, -b.low}; }

constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble product = product_of(a.high, b.high);
    return sum_of(product.high, product.low + (a.high * b.low + a.low * b.high));
}
constexpr DoubleDouble operator*(DoubleDouble a, double b) { return a * DoubleDouble(b); }

constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double quotient = a.high / b.high;
    const DoubleDouble rest = a - b * quotient;
    return sum_of(quotient, rest.high / b.high);
}

}  // namespace steplab
