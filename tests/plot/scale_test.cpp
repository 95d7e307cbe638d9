#include "plot/plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace steplab::plot {
namespace {

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
    std::vector<std::string> texts;
    for (const Tick& tick : ticks) texts.push_back(tick.label);
    return texts;
}

using Texts = std::vector<std::string>;

TEST(plot_axis, linear_ticks_are_at_nice_numbers) {
    EXPECT_EQ(labels(ticks({0, 12}, 4)), (Texts{"0", "5", "10"}));
    EXPECT_EQ(labels(ticks({-1, 1}, 4)), (Texts{"-1.0", "-0.5", "0", "0.5", "1.0"}));
    EXPECT_EQ(labels(ticks({0.001, 0.0023}, 3)), (Texts{"0.0010", "0.0015", "0.0020"}));
    EXPECT_EQ(labels(ticks({0, 2e6}, 4)), (Texts{"0", "5e5", "1.0e6", "1.5e6", "2.0e6"}));
}

TEST(plot_axis, labels_are_short_where_the_step_is_tiny_beside_the_values) {
    for (const Tick& tick : ticks({0.5, 0.5000001}, 4)) EXPECT_EQ(tick.label, "0.5");
}

TEST(plot_axis, logarithmic_ticks_are_at_powers_of_ten) {
    EXPECT_EQ(labels(ticks({1e-9, 1e-6, Scale::logarithmic}, 5)), (Texts{"1e-9", "1e-8", "1e-7", "1e-6"}));
    EXPECT_EQ(labels(ticks({0.05, 2000, Scale::logarithmic}, 9)), (Texts{"0.1", "1", "10", "100", "1000"}));
    EXPECT_EQ(ticks({1e-16, 1e4, Scale::logarithmic}, 4).size(), 5u);
}

TEST(plot_axis, powers_of_ten_are_written_as_the_quantity_is) {
    const auto texts = [](double low, double high, Numbers numbers) {
        return labels(ticks({.low = low, .high = high, .scale = Scale::logarithmic, .numbers = numbers}, 9));
    };
    EXPECT_EQ(texts(2e-7, 2e-3, Numbers::seconds), (Texts{"1 µs", "10 µs", "100 µs", "1 ms"}));
    EXPECT_EQ(texts(5e4, 2e6, Numbers::counts), (Texts{"100\u202f000", "1\u202f000\u202f000"}));
    EXPECT_EQ(texts(1e-7, 1e-5, Numbers::readable).front(), "10⁻⁷");
    EXPECT_EQ(texts(1e-7, 1e-5, Numbers::typed).front(), "1e-7");
}

TEST(plot_axis, empty_ranges_have_no_ticks) {
    EXPECT_TRUE(ticks({1, 1}, 5).empty());
    EXPECT_TRUE(ticks({NAN, 1}, 5).empty());
    EXPECT_TRUE(ticks({0, 1, Scale::logarithmic}, 5).empty());
    EXPECT_TRUE(ticks({-1, 1, Scale::logarithmic}, 5).empty());
}

TEST(plot_axis, pixels_and_values_are_inverse) {
    for (const bool logarithmic : {false, true}) {
        const Axis axis{1e-3, 1e2, logarithmic ? Scale::logarithmic : Scale::linear, 300, 20};
        EXPECT_FLOAT_EQ(axis.pixel(1e-3), 300);
        EXPECT_FLOAT_EQ(axis.pixel(1e2), 20);
        // Pixels are floats: 7 digits of the range, of its logarithm (11.5) where it is logarithmic.
        EXPECT_NEAR(axis.value(axis.pixel(0.5)), 0.5, logarithmic ? 1e-5 : 1e-4);
    }
}

TEST(plot_axis, decimation_bounds_the_points_and_keeps_every_peak) {
    constexpr std::size_t count = 100000;
    std::vector<double> x(count), y(count);
    std::iota(x.begin(), x.end(), 0.0);
    for (std::size_t i = 0; i < count; ++i) y[i] = std::sin(0.01 * x[i]);
    y[54321] = 7;
    y[77777] = -5;
    const Axis across{0, count - 1.0, Scale::linear, 0, 400};
    const Axis up{-5, 7, Scale::linear, 100, 0};
    const auto points = decimated(x, y, {across, up});
    EXPECT_LE(points.size(), 4u * 401u);
    const auto higher = [](const Point& a, const Point& b) { return a.y < b.y; };
    EXPECT_FLOAT_EQ(std::min_element(points.begin(), points.end(), higher)->y, up.pixel(7));
    EXPECT_FLOAT_EQ(std::max_element(points.begin(), points.end(), higher)->y, up.pixel(-5));
    EXPECT_TRUE(std::is_sorted(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; }));
}

// Joints of points that lie in one place would be drawn thicker than the line.
TEST(plot_axis, decimation_keeps_no_points_in_one_place_but_the_ends) {
    std::vector<double> x, y;
    for (int i = 0; i <= 5000; ++i) {
        x.push_back(i);
        y.push_back(1e-7 * i * i);
    }
    const Axes axes{{0, 5000, Scale::linear, 0, 400}, {0, 3, Scale::linear, 100, 0}};
    const auto points = decimated(x, y, axes);
    EXPECT_GT(points.size(), 300u);
    EXPECT_EQ(points.front().x, 0);
    EXPECT_EQ(points.back().x, 400);
    for (std::size_t i = 1; i < points.size(); ++i)
        ASSERT_GE(std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y), 0.75f) << i;
    const std::vector<double> same(100, 2);
    EXPECT_EQ(decimated(same, same, axes).size(), 2u) << "one place";
}

TEST(plot_axis, points_are_told_apart_by_those_that_are_shown) {
    std::vector<Point> points;
    for (int i = 0; i < 1000; ++i) points.push_back({static_cast<float>(20 * i), 5});
    EXPECT_TRUE(told_apart(points, {100, 0, 200, 50}, 12));
    EXPECT_FALSE(told_apart(points, {100, 0, 200, 50}, 25));
    EXPECT_TRUE(told_apart({}, {100, 0, 200, 50}, 12));
}

TEST(plot_axis, does_not_reach_to_the_ends_of_a_band_that_is_cut) {
    Plot plot{.curves = {{.x = {0, 1}, .y = {1, 2}}}, .bands = {{.x = {0, 1}, .low = {-50, -50}, .high = {70, 70}}}};
    EXPECT_GE(axes(plot, {0, 0, 100, 100}).up.high, 70);
    plot.bands[0].is_cut = true;
    EXPECT_EQ(axes(plot, {0, 0, 100, 100}).up.high, 2);
    EXPECT_GT(axes(plot, {0, 0, 100, 100}).up.low, -1);
    plot.curves.clear();
    EXPECT_GE(axes(plot, {0, 0, 100, 100}).up.high, 70) << "there is nothing else";
}

TEST(plot_axis, few_points_are_all_kept) {
    const std::vector<double> x = {0, 1, 2, 3};
    const std::vector<double> y = {1, 5, 2, 4};
    const auto points = decimated(x, y, {{0, 3, Scale::linear, 0, 300}, {0, 5, Scale::linear, 100, 0}});
    ASSERT_EQ(points.size(), 4u);
    EXPECT_FLOAT_EQ(points[1].y, 0);
    EXPECT_FLOAT_EQ(points[3].x, 300);
}

TEST(plot_axis, what_an_axis_cannot_show_is_left_out) {
    const std::vector<double> x = {0, 1, 2, 3};
    const std::vector<double> y = {0, NAN, -1, 4};
    EXPECT_EQ(decimated(x, y, {{0, 3, Scale::linear, 0, 300}, {-1, 5, Scale::linear, 100, 0}}).size(), 3u);
    EXPECT_EQ(decimated(x, y, {{0, 3, Scale::linear, 0, 300}, {0.1, 10, Scale::logarithmic, 100, 0}}).size(), 1u);
    EXPECT_TRUE(decimated({}, {}, {{}, {}}).empty());
}

TEST(plot_axis, nearest_value_is_found) {
    const std::vector<double> x = {0, 1, 2, 10};
    EXPECT_EQ(nearest(x, -5), 0u);
    EXPECT_EQ(nearest(x, 0.6), 1u);
    EXPECT_EQ(nearest(x, 5.9), 2u);
    EXPECT_EQ(nearest(x, 6.1), 3u);
    EXPECT_EQ(nearest(x, 100), 3u);
    EXPECT_EQ(nearest({}, 1), 0u);
}

}  // namespace
}  // namespace steplab::plot
