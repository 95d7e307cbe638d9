#include "core/number.hpp"

#include "core/dual.hpp"
#include "core/flush_subnormals.hpp"
#include "core/lanes.hpp"
#include "core/sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace steplab {
namespace {

/// Largest error of exponential() over a range in units of the last place of the result, of 64 bits at most, against
/// long double.
template <class T>
double worst_error_in_ulp(T low, T high) {
    double worst = 0;
    for (int i = 0; i <= 100000; ++i) {
        const T x = low + (high - low) * static_cast<T>(i) / T(100000);
        const long double right = std::exp(static_cast<long double>(x));
        const T result = exponential(x);
        const int places = std::min(std::numeric_limits<T>::digits, 64) - 1;
        const int exponent = std::max(std::ilogb(result), std::numeric_limits<T>::min_exponent - 1);
        const T ulp = std::ldexp(T(1), exponent - places);
        worst = std::max(worst, static_cast<double>(std::abs(static_cast<long double>(result) - right) /
                                                    static_cast<long double>(ulp)));
    }
    return worst;
}

// The reduction and the polynomial round a few times: less than 1.5 ulp in all is what number.hpp promises.
TEST(Exponential, is_accurate_within_one_and_a_half_ulp) {
    EXPECT_LT(worst_error_in_ulp<double>(-708.739, 709.436), 1.5);
    EXPECT_LT(worst_error_in_ulp<float>(-87.68f, 88.37f), 1.5);
    EXPECT_LT(worst_error_in_ulp<double>(-1, 1), 1.5);
    EXPECT_LT(worst_error_in_ulp<float>(-1, 1), 1.5);
    EXPECT_LT(worst_error_in_ulp<double>(-708.739, -708.3), 1.5);  // where results leave the normal numbers
    EXPECT_LT(worst_error_in_ulp<float>(-87.68f, -87.3f), 1.5);
}

// 1022.5 ln 2 = 708.7430, 1023.5 ln 2 = 709.4361; 126.5 ln 2 = 87.6831, 127.5 ln 2 = 88.3763.
TEST(Exponential, has_the_documented_range) {
    EXPECT_GT(exponential(-708.7429), 0.0);
    EXPECT_EQ(exponential(-708.7431), 0.0);
    EXPECT_LT(exponential(709.4361), std::numeric_limits<double>::infinity());
    EXPECT_EQ(exponential(709.4362), std::numeric_limits<double>::infinity());
    EXPECT_GT(exponential(-87.683f), 0.0f);
    EXPECT_EQ(exponential(-87.6832f), 0.0f);
    EXPECT_LT(exponential(88.3762f), std::numeric_limits<float>::infinity());
    EXPECT_EQ(exponential(88.3764f), std::numeric_limits<float>::infinity());
}

// libm's is within 1.1 ulp of x87's numbers, ours within 1.5. A degree less is 11 ulp off.
TEST(Exponential, of_references_is_accurate_within_one_and_a_half_ulp) {
    EXPECT_LT(worst_error_in_ulp<long double>(-11300, 11300), 2.6);
    EXPECT_LT(worst_error_in_ulp<long double>(-1, 1), 2.6);
}

TEST(Exponential, ends_in_zero_infinity_and_not_a_number) {
    EXPECT_EQ(exponential(0.0), 1.0);
    EXPECT_EQ(exponential(0.0f), 1.0f);
    EXPECT_EQ(exponential(-1000.0), 0.0);
    EXPECT_EQ(exponential(-1000.0f), 0.0f);
    EXPECT_EQ(exponential(1000.0), std::numeric_limits<double>::infinity());
    EXPECT_EQ(exponential(1000.0f), std::numeric_limits<float>::infinity());
    EXPECT_TRUE(std::isnan(exponential(std::numeric_limits<double>::quiet_NaN())));
    EXPECT_EQ(exponential(-std::numeric_limits<double>::infinity()), 0.0);
    EXPECT_EQ(exponential(0.0L), 1.0L);
    for (const long double x : {11400.0L, 1e30L, std::numeric_limits<long double>::infinity()})
        EXPECT_EQ(exponential(x), std::numeric_limits<long double>::infinity());
    EXPECT_GT(exponential(-11390.0L), 0.0L);
    for (const long double x : {-11500.0L, -1e30L, -std::numeric_limits<long double>::infinity()})
        EXPECT_EQ(exponential(x), 0.0L);
    EXPECT_TRUE(std::isnan(exponential(std::numeric_limits<long double>::quiet_NaN())));
}

// Bits computed once: every compiler, optimisation level and processor must reproduce them.
TEST(Exponential, gives_the_same_bits_everywhere) {
    EXPECT_EQ(__builtin_bit_cast(std::uint64_t, exponential(0.7)), 0x40001c2a61268987u);
    if constexpr (std::numeric_limits<long double>::digits == 64) {
        EXPECT_EQ(exponential(1.0L), 0xa.df85458a2bb4a9ap-2L);  // Intel's instructions end in ...9b
        EXPECT_EQ(exponential(-3.3L), 0x9.712cddc2df41d26p-8L);
        EXPECT_EQ(exponential(1000.25L), 0x8.50a33af1034f5e8p+1440L);
        EXPECT_EQ(exponential(-9999.5L), 0xd.a6aa5a369199a26p-14430L);
    }
}

TEST(Dual, carries_exact_derivatives) {
    const double x = 0.7;
    const Dual<double> d(x, 1.0);
    const auto f = exponential(d * d) / square_root(d + Dual<double>(1.0)) - d;
    const double e = std::exp(x * x), root = std::sqrt(x + 1);
    EXPECT_NEAR(f.value, e / root - x, 1e-15);  // a handful of roundings of numbers near 1
    EXPECT_NEAR(f.derivative, 2 * x * e / root - e / (2 * root * root * root) - 1,
                4e-15);  // likewise, of numbers near 2
}

TEST(Dual, the_root_of_zero_has_a_finite_derivative) {
    const auto root = square_root(Dual<double>(0.0, 1.0));
    EXPECT_EQ(root.value, 0);
    EXPECT_EQ(root.derivative, 0);
}

template <class T>
class LanesTest : public testing::Test {};
using LaneNumbers = testing::Types<float, double>;
TYPED_TEST_SUITE(LanesTest, LaneNumbers);

TYPED_TEST(LanesTest, compute_each_lane_as_a_single_number) {
    using T = TypeParam;
    using N = Lanes<T>;
    alignas(64) T a[N::count], b[N::count];
    std::mt19937 random(1);
    std::uniform_real_distribution<T> numbers(T(0.5), T(9));
    for (std::size_t i = 0; i < N::count; ++i) a[i] = numbers(random), b[i] = numbers(random);
    const N x = N::load(a), y = N::load(b);
    const N result = where(x < y, square_root(x) / y + x * y, x - y);
    for (std::size_t i = 0; i < N::count; ++i) {
        EXPECT_EQ(result[i], a[i] < b[i] ? std::sqrt(a[i]) / b[i] + a[i] * b[i] : a[i] - b[i]);
    }
}

TYPED_TEST(LanesTest, raise_e_to_each_lane_as_to_a_single_number) {
    using T = TypeParam;
    using N = Lanes<T>;
    alignas(64) T x[N::count];
    for (const double scale : {1e-3, 1.0, 20.0, 200.0}) {
        for (std::size_t i = 0; i < N::count; ++i) x[i] = static_cast<T>(scale * (static_cast<double>(i) - 3.3));
        const N result = exponential(N::load(x));
        for (std::size_t i = 0; i < N::count; ++i) EXPECT_EQ(result[i], exponential(x[i])) << x[i];
    }
    EXPECT_TRUE(std::isnan(exponential(N(std::numeric_limits<T>::quiet_NaN()))[0]));
}

TYPED_TEST(LanesTest, load_and_store_anywhere) {
    using T = TypeParam;
    using N = Lanes<T>;
    constexpr std::size_t size = N::count + 4;
    alignas(64) T numbers[size];
    for (std::size_t i = 0; i < size; ++i) numbers[i] = static_cast<T>(i);
    N::load_anywhere(numbers + 3).store_anywhere(numbers + 1);
    for (std::size_t i = 0; i < N::count; ++i) EXPECT_EQ(numbers[i + 1], static_cast<T>(i + 3));
    EXPECT_EQ(numbers[0], T(0));
    EXPECT_EQ(numbers[N::count + 1], static_cast<T>(N::count + 1));
}

TYPED_TEST(LanesTest, shift_through_neighbouring_registers) {
    using T = TypeParam;
    using N = Lanes<T>;
    constexpr std::size_t size = 2 * N::count;
    alignas(64) T numbers[size];
    for (std::size_t i = 0; i < size; ++i) numbers[i] = static_cast<T>(i);
    const N first = N::load(numbers), second = N::load(numbers + N::count);
    for (std::size_t i = 0; i < N::count; ++i) {
        EXPECT_EQ(N::shifted_down(first, second)[i], static_cast<T>(i + 1));
        EXPECT_EQ(N::shifted_up(first, second)[i], static_cast<T>(N::count + i - 1));
        EXPECT_EQ(where(N::first(3), first, second)[i], static_cast<T>(i < 3 ? i : N::count + i));
    }
}

// A plain sum loses every one of the small terms, each far below half an ulp of 1.
TEST(CompensatedSum, keeps_terms_far_below_an_ulp) {
    CompensatedSum sum;
    double plain = 1;
    sum.add(1);
    for (int i = 0; i < 1000; ++i) {
        sum.add(1e-17);
        plain += 1e-17;
    }
    sum.add(-1);
    EXPECT_NEAR(sum.value(), 1e-14, 1e-16);  // one rounding of a number near 1
    EXPECT_EQ(plain, 1);
}

TEST(CompensatedSum, is_not_finite_if_a_term_is_not) {
    CompensatedSum sum;
    sum.add(std::numeric_limits<double>::infinity());
    sum.add(1);
    EXPECT_FALSE(std::isfinite(sum.value()));
}

TEST(FlushSubnormals, makes_subnormals_zero_during_its_lifetime) {
    volatile double small = std::numeric_limits<double>::min();
    EXPECT_GT(small / 4, 0);
    {
        const FlushSubnormals flush;
        EXPECT_EQ(small / 4, 0);
    }
    EXPECT_GT(small / 4, 0);
}

}  // namespace
}  // namespace steplab
