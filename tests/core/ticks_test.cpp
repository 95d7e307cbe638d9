#include "core/ticks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace steplab {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
const double nan = std::nan("");

TEST(NiceNumbers, are_1_2_5_times_a_power_of_ten) {
    EXPECT_EQ(nice_ceil(0.7), 1);
    EXPECT_EQ(nice_ceil(1.01), 2);
    EXPECT_EQ(nice_ceil(4), 5);
    EXPECT_EQ(nice_ceil(60), 100);
    EXPECT_EQ(nice_ceil(0.003), 0.005);
    EXPECT_EQ(nice_floor(0.7), 0.5);
    EXPECT_EQ(nice_floor(4.9), 2);
    EXPECT_EQ(nice_floor(99), 50);
    EXPECT_EQ(nice_above(2), 5);
    EXPECT_EQ(nice_below(2), 1);
    EXPECT_EQ(nice_above(3), 5);
    EXPECT_EQ(nice_below(3), 2);
}

TEST(NiceNumbers, are_the_doubles_nearest_to_them) {
    EXPECT_EQ(nice_ceil(4e-6), 5e-6);
    EXPECT_EQ(nice_ceil(9e-6), 1e-5);
    EXPECT_EQ(nice_floor(6e-22), 5e-22);
    EXPECT_EQ(nice_floor(3e22), 2e22);
}

TEST(NiceNumbers, rounding_errors_do_not_skip_one) {
    EXPECT_EQ(nice_ceil(0.1 + 0.2 - 0.1), 0.2);
    EXPECT_EQ(nice_floor(1 - 1e-16), 1);
    EXPECT_EQ(nice_above(0.1 + 0.2 - 0.1), 0.5);
    EXPECT_EQ(nice_below(0.1 + 0.2 - 0.1), 0.1);
}

TEST(NiceNumbers, follow_each_other_without_a_gap) {
    double value = 1e-300;
    int count = 0;
    for (double next = nice_above(value); next < 1e300; next = nice_above(value)) {
        ASSERT_GT(next, 1.9 * value);
        ASSERT_LT(next, 2.6 * value);
        ASSERT_EQ(nice_below(next), value);
        value = next;
        ++count;
    }
    EXPECT_EQ(count, 3 * 600 - 1);
}

TEST(NiceNumbers, of_values_without_one_end) {
    for (const double value : {0.0, -1.0, infinite, -infinite, smallest}) {
        EXPECT_EQ(nice_ceil(value), value);
        EXPECT_EQ(nice_floor(value), value);
    }
    EXPECT_TRUE(std::isnan(nice_ceil(nan)));
    EXPECT_TRUE(std::isnan(nice_floor(nan)));
    EXPECT_EQ(nice_ceil(largest), infinite);
    EXPECT_EQ(nice_floor(largest), 1e308);
    EXPECT_EQ(nice_above(largest), infinite);
}

TEST(NiceNumbers, can_have_more_digits) {
    constexpr double fine[] = {1, 1.5, 4};
    EXPECT_EQ(nice_ceil(12, fine), 15);
    EXPECT_EQ(nice_ceil(50, fine), 100);
}

TEST(LinearTicks, are_the_multiples_of_the_step_with_both_ends) {
    EXPECT_THAT(linear_ticks(0, 12, 5), ElementsAre(0, 5, 10));
    EXPECT_THAT(linear_ticks(-1, 1, 0.5), ElementsAre(-1, -0.5, 0, 0.5, 1));
    EXPECT_EQ(linear_ticks(0, 1, 0.1).size(), 11u);
    EXPECT_FALSE(std::signbit(linear_ticks(-0.1, 0.1, 1).front())) << "zero has no sign";
}

TEST(LinearTicks, divide_any_range_as_asked) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-8, 8), place(-3, 3);
    for (int i = 0; i < 2000; ++i) {
        const double width = std::pow(10.0, exponent(random));
        const double low = place(random) * width;
        for (const int intervals : {1, 2, 5, 9}) {
            const auto ticks = linear_ticks(low, low + width, nice_step(low, low + width, intervals));
            ASSERT_LE(ticks.size(), static_cast<std::size_t>(intervals) + 1);
            // A nice step is at most 2.5 times the one that would be exact.
            ASSERT_GE(ticks.size() + 1, static_cast<std::size_t>(intervals / 2.5));
        }
    }
}

TEST(LinearTicks, are_none_where_there_is_no_range) {
    for (const auto& [low, high] : {std::pair{1.0, 1.0},
                                    {2.0, 1.0},
                                    {nan, 1.0},
                                    {0.0, nan},
                                    {nan, nan},
                                    {-infinite, infinite},
                                    {0.0, infinite},
                                    {1.0, std::nextafter(1.0, 2.0)},
                                    {1e16, std::nextafter(1e16, 2e16)},
                                    {0.0, smallest}}) {
        EXPECT_THAT(linear_ticks(low, high, nice_step(low, high, 5)), IsEmpty()) << low << " .. " << high;
    }
    EXPECT_THAT(linear_ticks(0, 1, 0), IsEmpty());
    EXPECT_THAT(linear_ticks(0, 1, -1), IsEmpty());
    EXPECT_THAT(linear_ticks(0, 1, nan), IsEmpty());
    EXPECT_THAT(linear_ticks(0, 1, infinite), IsEmpty());
}

TEST(LinearTicks, reach_as_far_as_doubles_do) {
    EXPECT_THAT(linear_ticks(-largest, largest, nice_step(-largest, largest, 5)), ElementsAre(-1e308, 0, 1e308));
}

TEST(LinearTicks, are_none_where_they_would_be_too_many_or_coincide) {
    EXPECT_THAT(linear_ticks(0, 1, 1e-6), IsEmpty());
    EXPECT_THAT(linear_ticks(1e20, 1e20 + 1e5, 20000), IsEmpty());
    EXPECT_THAT(linear_ticks(1e15, 1e15 + 1, 0.1), IsEmpty());
}

TEST(Decades, are_the_powers_of_ten_with_both_ends) {
    EXPECT_THAT(decades(1e-9, 1e-6), ElementsAre(-9, -8, -7, -6));
    EXPECT_THAT(decades(0.05, 2000), ElementsAre(-1, 0, 1, 2, 3));
    EXPECT_THAT(decades(2, 9), IsEmpty());
    EXPECT_THAT(decades(1, 1), ElementsAre(0));
    EXPECT_EQ(decades(smallest, largest).size(), 632u);
}

TEST(Decades, are_none_where_logarithms_are) {
    for (const auto& [low, high] :
         {std::pair{0.0, 1.0}, {-1.0, 1.0}, {2.0, 1.0}, {1.0, infinite}, {nan, 1.0}, {1.0, nan}})
        EXPECT_THAT(decades(low, high), IsEmpty()) << low << " .. " << high;
}

TEST(NiceRange, ends_at_ticks_and_holds_the_values) {
    const Range range = nice_range(-0.93, 2.1, 5);
    EXPECT_EQ(range.low, -1);
    EXPECT_EQ(range.high, 3);
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> exponent(-8, 8), place(-3, 3);
    for (int i = 0; i < 2000; ++i) {
        const double width = std::pow(10.0, exponent(random));
        const double low = place(random) * width;
        const Range found = nice_range(low, low + width, 4);
        // Rounding of the ends themselves, relative to the numbers they are made from.
        const double tolerance = 1e-8 * (width + std::abs(low));
        ASSERT_LE(found.low, low + tolerance);
        ASSERT_GE(found.high, low + width - tolerance);
        const auto ticks = linear_ticks(found.low, found.high, nice_step(found.low, found.high, 4));
        ASSERT_GE(ticks.size(), 2u);
        ASSERT_NEAR(ticks.front(), found.low, tolerance);
        ASSERT_NEAR(ticks.back(), found.high, tolerance);
    }
}

TEST(NiceRange, is_there_for_any_two_numbers) {
    EXPECT_LT(nice_range(5, 5, 5).low, 5);
    EXPECT_GT(nice_range(0, 0, 5).high, 0);
    for (const double low : {-largest, -1.0, -smallest, 0.0, smallest, 1.0, 1e16, largest, infinite, nan}) {
        for (const double high : {low, std::nextafter(low, infinite), 2 * low, largest, infinite, nan}) {
            for (const int intervals : {0, 1, 5}) {
                const Range range = nice_range(low, high, intervals);
                EXPECT_LT(range.low, range.high) << low << " .. " << high;
                EXPECT_TRUE(std::isfinite(range.low) && std::isfinite(range.high)) << low << " .. " << high;
            }
        }
    }
    const Range narrow = nice_range(1, std::nextafter(1.0, 2.0), 5);
    EXPECT_LE(narrow.low, 1);
    EXPECT_GT(narrow.high, 1);
    EXPECT_EQ(nice_range(-largest, largest, 5).high, largest) << "twice the largest number is none";
    EXPECT_EQ(nice_range(-1, 1, 1).low, -1) << "a range around 0 has two parts";
    EXPECT_EQ(nice_range(nan, 1, 5).high, 1);
}

TEST(DecadeRange, ends_at_powers_of_ten) {
    const Range range = decade_range(3e-8, 4e-8);
    EXPECT_EQ(range.low, 1e-8);
    EXPECT_EQ(range.high, 1e-7);
    EXPECT_EQ(decade_range(1e-3, 1e-3).high, 1e-2);
    for (const double value : {smallest, largest}) {
        const Range at_the_end = decade_range(value, value);
        EXPECT_GT(at_the_end.low, 0);
        EXPECT_GT(at_the_end.high, at_the_end.low);
        EXPECT_TRUE(std::isfinite(at_the_end.high));
    }
    EXPECT_EQ(decade_range(0, infinite).high, 1);
}

TEST(TickText, has_the_decimals_of_the_step) {
    EXPECT_EQ(tick_text(0.30000000000000004, 0.1, 1), "0.3");
    EXPECT_EQ(tick_text(-2, 0.5, 3), "-2.0");
    EXPECT_EQ(tick_text(20, 5, 30), "20");
    EXPECT_EQ(tick_text(1e-20, 0.5, 1), "0");
    EXPECT_EQ(tick_text(1'200'000, 200'000, 2e6), "1.2e6");
    EXPECT_EQ(tick_text(-3e-7, 1e-7, 1e-6), "-3e-7");
}

}  // namespace
}  // namespace steplab
