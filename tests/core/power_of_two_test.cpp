#include "core/power_of_two.hpp"

#include "core/lane_shuffles.hpp"
#include "core/stages.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace steplab {
namespace {

template <class T>
class PowerOfTwo : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(PowerOfTwo, Numbers);

template <class T>
T quotient(const Fraction<T>& fraction) {
    return fraction.numerator / fraction.denominator;
}

/// The range in which 2^x and its intermediate results neither underflow nor overflow.
template <class T>
constexpr T lowest = std::numeric_limits<T>::min_exponent;
template <class T>
constexpr T highest = sizeof(T) == 4 ? T(122) : T(1010);

/// Largest error of power_of_two(x) against exp2 of long double at x + off, in units of the last place.
template <class T>
double worst_power_in_ulp(T low, T high, T off = 0) {
    double worst = 0;
    for (int i = 0; i <= 100000; ++i) {
        const T x = low + (high - low) * static_cast<T>(i) / T(100000);
        const long double right = std::exp2(static_cast<long double>(x + off));
        const T result = quotient(power_of_two(x)), ulp = std::nextafter(result, T(INFINITY)) - result;
        const long double error = std::abs(static_cast<long double>(result) - right) / static_cast<long double>(ulp);
        if (!(error <= worst)) worst = static_cast<double>(error);  // also if it is not a number
    }
    return worst;
}

// Numerator and denominator round the last step of a sum and the terms before, much smaller ones, then the quotient is
// rounded: 2.5 ulp in all is what power_of_two.hpp promises.
TYPED_TEST(PowerOfTwo, is_accurate_within_two_and_a_half_ulp_over_the_whole_range) {
    using T = TypeParam;
    EXPECT_LT(worst_power_in_ulp<T>(lowest<T>, highest<T>), 2.5);
    EXPECT_LT(worst_power_in_ulp<T>(T(-2), T(2)), 2.5);
}

TYPED_TEST(PowerOfTwo, of_an_exponent_four_roundings_away_is_another_number) {
    using T = TypeParam;
    EXPECT_GT(worst_power_in_ulp<T>(T(1), T(2), 4 * std::numeric_limits<T>::epsilon()), 2.5);
}

TYPED_TEST(PowerOfTwo, of_an_integer_is_exact) {
    using T = TypeParam;
    for (T n = lowest<T>; n <= highest<T>; ++n)
        ASSERT_EQ(quotient(power_of_two(n)), std::ldexp(T(1), static_cast<int>(n))) << n;
}

TYPED_TEST(PowerOfTwo, ends_in_zero_infinity_and_not_a_number) {
    using T = TypeParam;
    constexpr T infinity = std::numeric_limits<T>::infinity(), most = std::numeric_limits<T>::max();
    for (const T x : {T(2000), T(1e30), most}) {
        EXPECT_EQ(quotient(power_of_two(x)), infinity) << x;
        EXPECT_EQ(quotient(power_of_two(-x)), 0) << -x;
    }
    EXPECT_EQ(quotient(power_of_two(-infinity)), 0);
    EXPECT_TRUE(std::isnan(quotient(power_of_two(std::numeric_limits<T>::quiet_NaN()))));
}

template <class N, class T>
void expect_each_lane_as_by_itself() {
    alignas(64) std::array<T, N::count> x;
    for (const double scale : {1e-3, 1.0, 20.0, 200.0}) {
        for (std::size_t i = 0; i < N::count; ++i) x[i] = static_cast<T>(scale * (static_cast<double>(i) - 3.3));
        const Fraction<N> lanes = power_of_two(N::load(x.data()));
        for (std::size_t i = 0; i < N::count; ++i) {
            const Fraction<T> alone = power_of_two(x[i]);
            EXPECT_EQ(lanes.numerator[i], alone.numerator) << x[i];
            EXPECT_EQ(lanes.denominator[i], alone.denominator) << x[i];
        }
    }
}

TYPED_TEST(PowerOfTwo, of_lanes_is_that_of_each_single_number) {
    using T = TypeParam;
    expect_each_lane_as_by_itself<Lanes<T>, T>();
    expect_each_lane_as_by_itself<CacheLineLanes<T>, T>();
    expect_each_lane_as_by_itself<RegisterLanes<T, 128 / sizeof(T)>, T>();
    expect_each_lane_as_by_itself<Stages<T>, T>();
}

template <class T>
class LaneShuffles : public testing::Test {
protected:
    using N = CacheLineLanes<T>;
    /// Numbers whose sums depend on the order.
    static N row(std::size_t r) {
        return N::each([=](std::size_t l) { return T(1) / static_cast<T>(3 + r * N::count + l); });
    }
};
TYPED_TEST_SUITE(LaneShuffles, Numbers);

TYPED_TEST(LaneShuffles, rotate_in_a_circle) {
    constexpr std::size_t count = TestFixture::N::count;
    const auto lanes = TestFixture::row(0);
    const auto one = rotated<1>(lanes), half = rotated<count / 2>(lanes), back = rotated<count - 1>(lanes);
    for (std::size_t l = 0; l < count; ++l) {
        EXPECT_EQ(one[l], lanes[(l + 1) % count]);
        EXPECT_EQ(half[l], lanes[(l + count / 2) % count]);
        EXPECT_EQ(back[l], lanes[(l + count - 1) % count]);
    }
}

TYPED_TEST(LaneShuffles, sum_rows_in_halves) {
    constexpr std::size_t count = TestFixture::N::count;
    std::array<typename TestFixture::N, count> rows;
    for (std::size_t r = 0; r < count; ++r) rows[r] = TestFixture::row(r);
    const auto sums = sums_of_rows(rows.data());
    bool in_turn = true;
    for (std::size_t r = 0; r < count; ++r) {
        std::array<TypeParam, count> row;
        TypeParam sum = 0;
        for (std::size_t l = 0; l < count; ++l) row[l] = rows[r][l], sum += row[l];
        for (std::size_t half = count / 2; half > 0; half /= 2) {
            for (std::size_t l = 0; l < half; ++l) row[l] += row[l + half];
        }
        EXPECT_EQ(sums[r], row[0]) << r;
        in_turn = in_turn && sums[r] == sum;
    }
    EXPECT_FALSE(in_turn) << "these numbers do not show an order";
}

}  // namespace
}  // namespace steplab
