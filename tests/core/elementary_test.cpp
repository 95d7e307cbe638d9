#include "core/elementary.hpp"

#include "core/elementary_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Units in the last place between a result and the value, of double or float.
template <class T>
double ulps(T result, long double value) {
    if (std::isinf(result) || std::isinf(static_cast<T>(value)))
        return result == static_cast<T>(value) ? 0 : static_cast<double>(infinity);
    constexpr int digits = std::numeric_limits<T>::digits, least = std::numeric_limits<T>::min_exponent;
    const int exponent = value == 0 ? least : std::max(std::ilogb(value) + 1, least);
    return static_cast<double>(std::abs(result - value) / std::ldexp(1.0L, exponent - digits));
}

template <class T>
struct Function {
    std::string name;
    T (*ours)(T);
    long double (*value)(long double);
};

template <class T>
std::vector<Function<T>> functions() {
    return {{"log", [](T x) { return natural_logarithm(x); }, [](long double x) { return std::log(x); }},
            {"sin", [](T x) { return sine(x); }, [](long double x) { return std::sin(x); }},
            {"cos", [](T x) { return cosine(x); }, [](long double x) { return std::cos(x); }},
            {"tan", [](T x) { return tangent(x); }, [](long double x) { return std::tan(x); }},
            {"tanh", [](T x) { return hyperbolic_tangent(x); }, [](long double x) { return std::tanh(x); }}};
}

/// Over all magnitudes, subnormal and largest ones included, around 1, and near multiples of pi / 2.
template <class T>
std::vector<T> arguments() {
    std::mt19937_64 random(2008);
    std::vector<T> all{T(0), std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::min(),
                       std::numeric_limits<T>::max()};
    const double low = std::log(static_cast<double>(std::numeric_limits<T>::min())) - 10;
    std::uniform_real_distribution<double> magnitude(low, -low - 10), near(-30, 30);
    for (int i = 0; i < 20000; ++i) {
        all.push_back(static_cast<T>(std::exp(magnitude(random))));
        all.push_back(static_cast<T>(near(random)));
        all.push_back(static_cast<T>(i * 1.5707963267948966192L * (1 + i % 50)));
    }
    // The double that is nearest to a multiple of pi / 2 (Muller, Elementary Functions (2006), table 11.1).
    all.push_back(static_cast<T>(0x1.6ac5b262ca1ffp+849));
    return all;
}

// The long double of x86 has 11 bits more than double, so its own error is 1/1000 ulp here.
template <class T>
void expect_accurate(double most) {
    for (const Function<T>& function : functions<T>()) {
        double worst = 0;
        T where = 0;
        for (const T x : arguments<T>()) {
            for (const T argument : {x, -x}) {
                const long double value = function.value(static_cast<long double>(argument));
                const T ours = function.ours(argument);
                if (std::isnan(value)) {
                    EXPECT_TRUE(std::isnan(ours)) << function.name << ' ' << argument;
                } else if (const double error = ulps(ours, value); !(error <= worst)) {
                    worst = error, where = argument;
                }
            }
        }
        EXPECT_LE(worst, most) << function.name << " at " << where;
    }
}

TEST(Elementary, is_within_two_ulp_of_double) { expect_accurate<double>(2); }
TEST(Elementary, is_within_one_ulp_of_float) { expect_accurate<float>(1); }

// Exponents as large as results allow: an error of the logarithm is multiplied by up to 700.
TEST(Elementary, powers_are_within_two_ulp) {
    std::mt19937_64 random(7);
    double worst = 0;
    for (int i = 0; i < 200000; ++i) {
        const double near = std::uniform_real_distribution<double>(0.9, 1.1)(random);
        const double any = std::exp(std::uniform_real_distribution<double>(-700, 700)(random));
        const double base = i % 2 == 0 ? near : any;
        const double most = 707 / std::max(1e-3, std::abs(std::log(base)));
        const double exponent = std::uniform_real_distribution<double>(-most, most)(random);
        worst =
            std::max(worst, ulps(general_power(base, exponent), std::pow(static_cast<long double>(base), exponent)));
    }
    EXPECT_LE(worst, 2);
}

TEST(Elementary, ends_of_the_domains) {
    EXPECT_EQ(natural_logarithm(0.0), -infinity);
    EXPECT_TRUE(std::isnan(natural_logarithm(-1.0)));
    EXPECT_EQ(natural_logarithm(infinity), infinity);
    EXPECT_EQ(natural_logarithm(1.0), 0);
    for (const double x : {infinity, -infinity, std::nan("")}) {
        EXPECT_TRUE(std::isnan(sine(x)) && std::isnan(cosine(x)) && std::isnan(tangent(x))) << x;
    }
    EXPECT_EQ(hyperbolic_tangent(infinity), 1);
    EXPECT_EQ(hyperbolic_tangent(-infinity), -1);
    EXPECT_TRUE(std::isnan(hyperbolic_tangent(std::nan(""))));
    EXPECT_TRUE(std::signbit(sine(-0.0)) && std::signbit(tangent(-0.0)) && std::signbit(hyperbolic_tangent(-0.0)));
}

TEST(Elementary, ends_of_powers) {
    EXPECT_EQ(general_power(0.0, 0.0), 1);
    EXPECT_EQ(general_power(std::nan(""), 0.0), 1);
    EXPECT_EQ(general_power(0.0, 2.5), 0);
    EXPECT_EQ(general_power(0.0, -2.5), infinity);
    EXPECT_EQ(general_power(-2.0, 3.0), -8);
    EXPECT_EQ(general_power(-2.0, -2.0), 0.25);
    EXPECT_TRUE(std::isnan(general_power(-2.0, 0.5)));
    EXPECT_EQ(general_power(2.0, 2000.0), infinity);
    EXPECT_EQ(general_power(2.0, -2000.0), 0);
    EXPECT_EQ(general_power(0.5, infinity), 0);
    EXPECT_EQ(general_power(3.0, infinity), infinity);
    EXPECT_EQ(general_power(1.5, 1e300), infinity);
    EXPECT_EQ(general_power(0.75, -1e300), infinity);
    EXPECT_EQ(general_power(infinity, -1.0), 0);
}

template <class T>
void expect_equal_lanes() {
    using N = RegisterLanes<T, 16>;
    const std::vector<T> all = arguments<T>();
    const auto at = [&](std::size_t i) { return all[i * 97 % all.size()]; };
    const N x = N::each([&](std::size_t lane) { return at(lane); });
    const N y = N::each([&](std::size_t lane) { return at(lane + 40); });
    const auto same = [](T a, T b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    for (std::size_t lane = 0; lane < N::count; ++lane) {
        EXPECT_TRUE(same(natural_logarithm(x)[lane], natural_logarithm(at(lane))));
        EXPECT_TRUE(same(sine(x)[lane], sine(at(lane))));
        EXPECT_TRUE(same(cosine(x)[lane], cosine(at(lane))));
        EXPECT_TRUE(same(tangent(x)[lane], tangent(at(lane))));
        EXPECT_TRUE(same(hyperbolic_tangent(x)[lane], hyperbolic_tangent(at(lane))));
        EXPECT_TRUE(same(general_power(x, y)[lane], general_power(at(lane), at(lane + 40))));
    }
}
TEST(Elementary, lanes_have_the_bits_of_single_numbers) {
    expect_equal_lanes<float>();
    expect_equal_lanes<double>();
}

}  // namespace
}  // namespace steplab::test
