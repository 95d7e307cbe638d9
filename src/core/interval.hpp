#pragma once
// Where the values of an expression can lie while its variables go over a range.

#include "core/elementary.hpp"
#include "core/number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace steplab {

/// All numbers from low to high. Operations give no less than what their operands can give, but for rounding; what has
/// no value somewhere is unbounded.
struct Interval {
    double low = 0, high = 0;

    Interval() = default;
    template <class Number>
    explicit Interval(Number number) : low(static_cast<double>(number)), high(low) {}
    Interval(double from, double to) : low(std::min(from, to)), high(std::max(from, to)) {}

    static Interval unbounded() {
        constexpr double most = std::numeric_limits<double>::infinity();
        return {-most, most};
    }
    bool has(double number) const { return low <= number && number <= high; }
    double largest() const { return std::max(std::abs(low), std::abs(high)); }

    friend Interval operator+(Interval a, Interval b) { return checked(a.low + b.low, a.high + b.high); }
    friend Interval operator-(Interval a, Interval b) { return checked(a.low - b.high, a.high - b.low); }
    friend Interval operator*(Interval a, Interval b) {
        const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
        return std::isnan(p + q + r + s) ? unbounded() : Interval(std::min({p, q, r, s}), std::max({p, q, r, s}));
    }
    friend Interval operator/(Interval a, Interval b) {
        return b.has(0) ? unbounded() : a * Interval(1 / b.high, 1 / b.low);
    }

    /// Of a < b.
    enum class Order { yes, no, perhaps };
    friend Order operator<(Interval a, Interval b) {
        if (a.high < b.low) return Order::yes;
        return a.low >= b.high ? Order::no : Order::perhaps;
    }

    /// From two values that are its ends, if they are numbers.
    static Interval checked(double from, double to) {
        return std::isnan(from) || std::isnan(to) ? unbounded() : Interval(from, to);
    }
};

inline Interval where(Interval::Order order, Interval then, Interval otherwise) {
    if (order == Interval::Order::yes) return then;
    if (order == Interval::Order::no) return otherwise;
    return {std::min(then.low, otherwise.low), std::max(then.high, otherwise.high)};
}

inline Interval exponential(Interval x) { return Interval::checked(exponential(x.low), exponential(x.high)); }
inline Interval natural_logarithm(Interval x) {
    return x.low > 0 ? Interval(natural_logarithm(x.low), natural_logarithm(x.high)) : Interval::unbounded();
}
inline Interval square_root(Interval x) {
    return x.high < 0 ? Interval::unbounded() : Interval(std::sqrt(std::max(x.low, 0.0)), std::sqrt(x.high));
}
inline Interval hyperbolic_tangent(Interval x) { return {hyperbolic_tangent(x.low), hyperbolic_tangent(x.high)}; }

namespace detail {

/// Of a function between -1 and 1 that changes no faster than its argument.
template <class F>
Interval of_wave(Interval x, F f) {
    const double half = (x.high - x.low) / 2;
    if (!(half < 1)) return {-1, 1};
    const double middle = f(x.low + half);
    return {std::max(middle - half, -1.0), std::min(middle + half, 1.0)};
}

}  // namespace detail

inline Interval sine(Interval x) {
    return detail::of_wave(x, [](double at) { return sine(at); });
}
inline Interval cosine(Interval x) {
    return detail::of_wave(x, [](double at) { return cosine(at); });
}
inline Interval tangent(Interval x) {
    const bool one_branch = x.high - x.low < 1 && !cosine(x).has(0);
    return one_branch ? Interval(tangent(x.low), tangent(x.high)) : Interval::unbounded();
}
inline Interval general_power(Interval base, Interval exponent) {
    if (base.low > 0) return exponential(exponent * natural_logarithm(base));
    const bool known = exponent.low == exponent.high && is_whole(exponent.low) && exponent.low > 0;
    if (!known) return Interval::unbounded();
    const double from = general_power(base.low, exponent.low), to = general_power(base.high, exponent.low);
    return base.has(0) ? Interval(std::min({from, to, 0.0}), std::max({from, to, 0.0})) : Interval(from, to);
}

}  // namespace steplab
