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

using NumbersOfRuns = testing::Types<float, double>;
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

template <class T>
class ElementaryOf : public testing::Test {};
TYPED_TEST_SUITE(ElementaryOf, NumbersOfRuns);

// Exponents as large as results allow: an error of the logarithm is multiplied by up to 700.
TYPED_TEST(ElementaryOf, powers_are_within_two_ulp) {
    using T = TypeParam;
    const double largest = std::log(static_cast<double>(std::numeric_limits<T>::max()));
    std::mt19937_64 random(7);
    double worst = 0;
    for (int i = 0; i < 200000; ++i) {
        const double near = std::uniform_real_distribution<double>(0.9, 1.1)(random);
        const double any = std::exp(std::uniform_real_distribution<double>(-largest, largest)(random));
        const auto base = static_cast<T>(i % 2 == 0 ? near : any);
        const double most = (largest - 2) / std::max(1e-3, std::abs(std::log(static_cast<double>(base))));
        const auto exponent = static_cast<T>(std::uniform_real_distribution<double>(-most, most)(random));
        const long double value = std::pow(static_cast<long double>(base), static_cast<long double>(exponent));
        worst = std::max(worst, ulps(general_power(base, exponent), value));
    }
    EXPECT_LE(worst, 2);
}

TYPED_TEST(ElementaryOf, functions_end_as_those_of_the_language) {
    using T = TypeParam;
    constexpr T endless = std::numeric_limits<T>::infinity(), unknown = std::numeric_limits<T>::quiet_NaN();
    EXPECT_EQ(natural_logarithm(T(0)), -endless);
    EXPECT_TRUE(std::isnan(natural_logarithm(T(-1))));
    EXPECT_EQ(natural_logarithm(endless), endless);
    EXPECT_EQ(natural_logarithm(T(1)), 0);
    for (const T x : {endless, -endless, unknown})
        EXPECT_TRUE(std::isnan(sine(x)) && std::isnan(cosine(x)) && std::isnan(tangent(x))) << x;
    EXPECT_EQ(hyperbolic_tangent(endless), 1);
    EXPECT_EQ(hyperbolic_tangent(-endless), -1);
    EXPECT_TRUE(std::isnan(hyperbolic_tangent(unknown)));
    const T zero = -T(0);
    EXPECT_TRUE(std::signbit(sine(zero)) && std::signbit(tangent(zero)) && std::signbit(hyperbolic_tangent(zero)));
}

TYPED_TEST(ElementaryOf, powers_end_as_those_of_the_language) {
    using T = TypeParam;
    constexpr T endless = std::numeric_limits<T>::infinity(), unknown = std::numeric_limits<T>::quiet_NaN(),
                huge = std::numeric_limits<T>::max() / 4;
    EXPECT_EQ(general_power(T(0), T(0)), 1);
    EXPECT_EQ(general_power(unknown, T(0)), 1);
    EXPECT_EQ(general_power(T(0), T(2.5)), 0);
    EXPECT_EQ(general_power(T(0), T(-2.5)), endless);
    EXPECT_EQ(general_power(T(-2), T(3)), -8);
    EXPECT_EQ(general_power(T(-2), T(-2)), T(0.25));
    EXPECT_TRUE(std::isnan(general_power(T(-2), T(0.5))));
    EXPECT_EQ(general_power(T(2), T(2000)), endless);
    EXPECT_EQ(general_power(T(2), T(-2000)), 0);
    EXPECT_EQ(general_power(T(0.5), endless), 0);
    EXPECT_EQ(general_power(T(3), endless), endless);
    EXPECT_EQ(general_power(T(1.5), huge), endless);
    EXPECT_EQ(general_power(T(0.75), -huge), endless);
    EXPECT_EQ(general_power(endless, T(-1)), 0);
}

template <class T, std::size_t width>
void expect_equal_lanes() {
    using N = RegisterLanes<T, width>;
    const std::vector<T> all = arguments<T>();
    const auto same = [](T a, T b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    for (std::size_t first = 0; first < all.size(); first += width) {
        const auto at = [&](std::size_t i) { return all[(first + i) * 97 % all.size()]; };
        const N x = N::each([&](std::size_t lane) { return at(lane); });
        const N y = N::each([&](std::size_t lane) { return at(lane + 40); });
        const N logarithms = natural_logarithm(x), sines = sine(x), cosines = cosine(x), tangents = tangent(x),
                hyperbolic = hyperbolic_tangent(x), powers = general_power(x, y);
        for (std::size_t lane = 0; lane < width; ++lane) {
            ASSERT_TRUE(same(logarithms[lane], natural_logarithm(at(lane)))) << at(lane);
            ASSERT_TRUE(same(sines[lane], sine(at(lane)))) << at(lane);
            ASSERT_TRUE(same(cosines[lane], cosine(at(lane)))) << at(lane);
            ASSERT_TRUE(same(tangents[lane], tangent(at(lane)))) << at(lane);
            ASSERT_TRUE(same(hyperbolic[lane], hyperbolic_tangent(at(lane)))) << at(lane);
            ASSERT_TRUE(same(powers[lane], general_power(at(lane), at(lane + 40)))) << at(lane) << ' ' << at(lane + 40);
        }
    }
}
TYPED_TEST(ElementaryOf, lanes_have_the_bits_of_single_numbers) {
    expect_equal_lanes<TypeParam, 4>();
    expect_equal_lanes<TypeParam, 8>();
    expect_equal_lanes<TypeParam, 16>();
}

}  // namespace
}  // namespace steplab::test
