#include "methods/engines/power_series.hpp"

#include "models/forces/layouts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace steplab::test {
namespace {

constexpr std::size_t terms = 20;
template <class T>
using Coefficients = std::array<T, terms>;

/// The coefficients of f(series), x being the coefficients of its argument, computed order by order.
template <class T, class F>
Coefficients<T> series_of(const Coefficients<T>& x, F f) {
    std::array<Lanes<T>, SeriesTape<T>::most_kept * terms> memory;
    Coefficients<T> result{};
    for (std::size_t k = 0; k < terms; ++k) {
        SeriesTape<T> tape(memory.data(), terms, k);
        result[k] = f(Series<T>::variable(tape, Lanes<T>(x[k]))).coefficient()[0];
    }
    return result;
}

/// Coefficients of e^(rate t).
template <class T>
Coefficients<T> exponential_series(T rate) {
    Coefficients<T> e{};
    e[0] = T(1);
    for (std::size_t k = 1; k < terms; ++k) e[k] = e[k - 1] * rate / static_cast<T>(static_cast<int>(k));
    return e;
}

template <class T>
T largest_difference(const Coefficients<T>& a, const Coefficients<T>& b) {
    T most = T(0);
    for (std::size_t k = 0; k < terms; ++k) most = std::max(most, std::abs(a[k] - b[k]));
    return most;
}

// With x = e^t: every rule against the series in closed form. Sums of 20 products below 1.
TEST(Series, of_every_operation_is_that_of_the_function) {
    const auto x = exponential_series(1.0);
    const Coefficients<double> time{0, 1};
    const auto expect = [&](const char* what, const Coefficients<double>& got, const Coefficients<double>& right) {
        EXPECT_LT(largest_difference(got, right), 1e-14) << what;
    };
    using S = Series<double>;
    expect("square", series_of(x, [](S s) { return s * s; }), exponential_series(2.0));
    expect("product", series_of(x, [](S s) { return s * (s * s); }), exponential_series(3.0));
    expect("quotient", series_of(x, [](S s) { return s / (s * s * s); }), exponential_series(-2.0));
    expect("reciprocal", series_of(x, [](S s) { return S(1) / s; }), exponential_series(-1.0));
    expect("root", series_of(x, [](S s) { return square_root(s); }), exponential_series(0.5));
    expect("exponential", series_of(time, [](S s) { return exponential(S(3) * s); }), exponential_series(3.0));
    expect("shifted product", series_of(x, [](S s) { return (s + S(2)) * (s - S(2)) + S(4); }),
           exponential_series(2.0));
    expect("taken from a constant", series_of(x, [](S s) { return S(5) - (S(5) - s); }), x);
    expect("choice", series_of(x, [](S s) { return where(s > S(0), s, S(1)); }), x);
}

TEST(Series, with_a_wrong_rule_is_not) {
    const auto x = exponential_series(1.0);
    const auto not_the_root = series_of(x, [](Series<double> s) { return square_root(s * Series<double>(1.001)); });
    EXPECT_GT(largest_difference(not_the_root, exponential_series(0.5)), 1e-4);
}

TEST(Series, of_a_root_at_zero_is_zero) {
    const auto root = series_of(Coefficients<double>{}, [](Series<double> s) { return square_root(s); });
    EXPECT_EQ(largest_difference(root, Coefficients<double>{}), 0);
}

// The formulas of forces themselves: double against long double. Coefficients fall like those of their argument.
TEST(Series, of_the_forces_in_double_are_those_of_long_double) {
    const auto spring = [](auto number) {
        using T = decltype(number);
        const SpringFormula<T> formula{{T(1), T(0), T(0.5)}, T(1.25), T(2)};
        return series_of(exponential_series(T(-0.5)),
                         [&](Series<T> s) { return formula(s * Series<T>(T(0.25)), s, s * s).y; });
    };
    const auto morse = [](auto number) {
        using T = decltype(number);
        const MorseFormula<T> formula{morse_constants<T>({.count = 2})};
        return series_of(exponential_series(T(-0.5)),
                         [&](Series<T> s) { return formula(s, s * s, Series<T>(T(1))).x; });
    };
    const auto expect_equal = [](const Coefficients<double>& a, const Coefficients<long double>& b) {
        for (std::size_t k = 0; k < terms; ++k) EXPECT_NEAR(a[k], static_cast<double>(b[k]), 1e-14) << k;
    };
    expect_equal(spring(0.0), spring(0.0L));
    expect_equal(morse(0.0), morse(0.0L));
}

}  // namespace
}  // namespace steplab::test
