#include "ui/plot/axis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace steplab::ui {
namespace {

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
    std::vector<std::string> texts;
    for (const Tick& tick : ticks) texts.push_back(tick.label);
    return texts;
}

using Texts = std::vector<std::string>;

TEST(axis, linear_ticks_stand_at_1_2_5) {
    EXPECT_EQ(labels(linear_ticks(0, 12, 4)), (Texts{"0", "5", "10"}));
    EXPECT_EQ(labels(linear_ticks(-1, 1, 4)), (Texts{"-1.0", "-0.5", "0.0", "0.5", "1.0"}));
    EXPECT_EQ(labels(linear_ticks(0.001, 0.0023, 3)), (Texts{"0.0010", "0.0015", "0.0020"}));
    EXPECT_EQ(labels(linear_ticks(0, 2e6, 4)), (Texts{"0", "5e+05", "1e+06", "1.5e+06", "2e+06"}));
}

TEST(axis, linear_ticks_part_any_range_as_asked) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-8, 8), place(-3, 3);
    for (int i = 0; i < 2000; ++i) {
        const double width = std::pow(10.0, exponent(random));
        const double low = place(random) * width;
        for (const int most : {1, 2, 5, 9}) {
            const auto found = linear_ticks(low, low + width, most);
            ASSERT_LE(found.size(), static_cast<std::size_t>(most) + 1);
            // A step of 1, 2, 5 is at most 2.5 times the one wanted.
            ASSERT_GE(found.size() + 1, static_cast<std::size_t>(most / 2.5));
            for (const Tick& tick : found) {
                ASSERT_GE(tick.value, low - 1e-8 * width);
                ASSERT_LE(tick.value, low + width + 1e-8 * width);
            }
        }
    }
}

TEST(axis, logarithmic_ticks_are_powers_of_ten) {
    EXPECT_EQ(labels(logarithmic_ticks(1e-9, 1e-6, 5)), (Texts{"1e-9", "1e-8", "1e-7", "1e-6"}));
    EXPECT_EQ(labels(logarithmic_ticks(0.05, 2000, 9)), (Texts{"0.1", "1", "10", "100", "1000"}));
    EXPECT_EQ(logarithmic_ticks(1e-16, 1e4, 4).size(), 5u);
}

TEST(axis, empty_ranges_have_no_ticks) {
    EXPECT_TRUE(linear_ticks(1, 1, 5).empty());
    EXPECT_TRUE(linear_ticks(NAN, 1, 5).empty());
    EXPECT_TRUE(logarithmic_ticks(0, 1, 5).empty());
    EXPECT_TRUE(logarithmic_ticks(-1, 1, 5).empty());
}

TEST(axis, ranges_end_at_round_numbers_and_hold_the_values) {
    const Range range = round_range(-0.93, 2.1, 5);
    EXPECT_DOUBLE_EQ(range.low, -1);
    EXPECT_DOUBLE_EQ(range.high, 3);
    EXPECT_LT(round_range(5, 5, 5).low, 5);
    EXPECT_GT(round_range(0, 0, 5).high, 0);
    const Range decades = round_logarithmic_range(3e-8, 4e-8);
    EXPECT_DOUBLE_EQ(decades.low, 1e-8);
    EXPECT_DOUBLE_EQ(decades.high, 1e-7);
    EXPECT_GT(round_logarithmic_range(1e-3, 1e-3).high, 1e-3);
}

TEST(axis, ends_of_a_range_are_ticks) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> exponent(-8, 8), place(-3, 3);
    for (int i = 0; i < 2000; ++i) {
        const double width = std::pow(10.0, exponent(random));
        const double low = place(random) * width;
        const Range range = round_range(low, low + width, 4);
        // Rounding of the ends themselves, relative to the numbers they are made from.
        const double slack = 1e-8 * (width + std::abs(low));
        ASSERT_LE(range.low, low + slack);
        ASSERT_GE(range.high, low + width - slack);
        const auto found = linear_ticks(range.low, range.high, 4);
        ASSERT_GE(found.size(), 2u);
        ASSERT_NEAR(found.front().value, range.low, slack);
        ASSERT_NEAR(found.back().value, range.high, slack);
    }
}

TEST(axis, pixels_and_values_are_inverse) {
    for (const bool logarithmic : {false, true}) {
        const Axis axis{1e-3, 1e2, logarithmic, 300, 20};
        EXPECT_FLOAT_EQ(axis.pixel(1e-3), 300);
        EXPECT_FLOAT_EQ(axis.pixel(1e2), 20);
        // Pixels are floats: 7 digits of the range, of its logarithm (11.5) where it is logarithmic.
        EXPECT_NEAR(axis.value(axis.pixel(0.5)), 0.5, logarithmic ? 1e-5 : 1e-4);
    }
}

TEST(axis, decimation_bounds_the_points_and_keeps_every_peak) {
    constexpr std::size_t count = 100000;
    std::vector<double> x(count), y(count);
    std::iota(x.begin(), x.end(), 0.0);
    for (std::size_t i = 0; i < count; ++i) y[i] = std::sin(0.01 * x[i]);
    y[54321] = 7;
    y[77777] = -5;
    const Axis across{0, count - 1.0, false, 0, 400};
    const Axis up{-5, 7, false, 100, 0};
    const auto points = decimated(x, y, across, up);
    EXPECT_LE(points.size(), 4u * 401u);
    const auto higher = [](const PlotPoint& a, const PlotPoint& b) { return a.y < b.y; };
    EXPECT_FLOAT_EQ(std::min_element(points.begin(), points.end(), higher)->y, up.pixel(7));
    EXPECT_FLOAT_EQ(std::max_element(points.begin(), points.end(), higher)->y, up.pixel(-5));
    EXPECT_TRUE(
        std::is_sorted(points.begin(), points.end(), [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; }));
}

TEST(axis, few_points_are_all_kept) {
    const std::vector<double> x = {0, 1, 2, 3};
    const std::vector<double> y = {1, 5, 2, 4};
    const auto points = decimated(x, y, {0, 3, false, 0, 300}, {0, 5, false, 100, 0});
    ASSERT_EQ(points.size(), 4u);
    EXPECT_FLOAT_EQ(points[1].y, 0);
    EXPECT_FLOAT_EQ(points[3].x, 300);
}

TEST(axis, what_an_axis_cannot_show_is_left_out) {
    const std::vector<double> x = {0, 1, 2, 3};
    const std::vector<double> y = {0, NAN, -1, 4};
    EXPECT_EQ(decimated(x, y, {0, 3, false, 0, 300}, {-1, 5, false, 100, 0}).size(), 3u);
    EXPECT_EQ(decimated(x, y, {0, 3, false, 0, 300}, {0.1, 10, true, 100, 0}).size(), 1u);
    EXPECT_TRUE(decimated({}, {}, {}, {}).empty());
}

TEST(axis, nearest_value_is_found) {
    const std::vector<double> x = {0, 1, 2, 10};
    EXPECT_EQ(nearest(x, -5), 0u);
    EXPECT_EQ(nearest(x, 0.6), 1u);
    EXPECT_EQ(nearest(x, 5.9), 2u);
    EXPECT_EQ(nearest(x, 6.1), 3u);
    EXPECT_EQ(nearest(x, 100), 3u);
    EXPECT_EQ(nearest({}, 1), 0u);
}

}  // namespace
}  // namespace steplab::ui
