#include "plot/plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace steplab::plot {
namespace {

Plot two_curves() {
    Plot plot;
    plot.name = "test";
    plot.curves = {{.name = "run", .x = {0, 0.1, 0.2}, .y = {1, 2.5, -3}},
                   {.name = "exact", .colour = Curve::exact, .x = {0, 0.1, 0.2}, .y = {1, NAN, -3.125}}};
    return plot;
}

TEST(plot, csv_has_a_column_for_each_curve) {
    EXPECT_EQ(csv(two_curves()), "time,run,exact\n0,1,1\n0.1,2.5,\n0.2,-3,-3.125\n");
}

TEST(plot, csv_has_the_x_of_all_curves) {
    Plot plot = two_curves();
    plot.curves[1].x = {0.05, 0.1, 0.3};
    EXPECT_EQ(csv(plot), "time,run,exact\n0,1,\n0.05,,1\n0.1,2.5,\n0.2,-3,\n0.3,,-3.125\n");
}

TEST(plot, csv_of_a_path_has_its_points_in_order) {
    Plot plot{.x = {.name = "displacement"}, .y = {.name = "velocity"}};
    plot.curves = {{.name = "run", .ascending = false, .x = {1, 0, -1, 0}, .y = {0, 2, 0, -2}}};
    EXPECT_EQ(csv(plot), "curve,displacement,velocity\nrun,1,0\nrun,0,2\nrun,-1,0\nrun,0,-2\n");
}

TEST(plot, csv_quotes_names_that_would_be_read_as_several_cells) {
    Plot plot = two_curves();
    plot.curves[0].name = "rk4, dt 0.01 s";
    plot.curves[1].name = "a \"good\"\nrun";
    plot.bands = {{.name = "low, high", .x = {0}, .low = {0}, .high = {2}}};
    const std::string head = csv(plot).substr(0, csv(plot).find("\n0,"));
    EXPECT_EQ(head, "time,\"rk4, dt 0.01 s\",\"a \"\"good\"\"\nrun\",\"low, high low\",\"low, high high\"");
}

TEST(plot, csv_of_a_path_quotes_such_names_in_head_and_rows) {
    Plot plot{.x = {.name = "evaluations"}, .y = {.name = "error after 10 s, 50 % of the series"}};
    plot.curves = {{.name = "rk4, dt 0.01 s", .ascending = false, .x = {1}, .y = {2}}};
    EXPECT_EQ(csv(plot), "curve,evaluations,\"error after 10 s, 50 % of the series\"\n\"rk4, dt 0.01 s\",1,2\n");
}

TEST(plot, axes_hold_every_value) {
    const Axes axes = plot::axes(two_curves(), {10, 20, 300, 100});
    EXPECT_FLOAT_EQ(axes.across.pixel(0), 10);
    EXPECT_FLOAT_EQ(axes.across.pixel(0.2), 310);
    EXPECT_LE(axes.up.low, -3.125);
    EXPECT_GE(axes.up.high, 2.5);
}

TEST(plot, only_positive_values_count_on_a_logarithmic_axis) {
    Plot plot = two_curves();
    plot.y.scale = Scale::logarithmic;
    EXPECT_TRUE(has_values(plot));
    EXPECT_GT(axes(plot, {0, 0, 100, 100}).up.low, 0);
    for (Curve& curve : plot.curves) curve.y = {0, -1, NAN};
    EXPECT_FALSE(has_values(plot));
}

TEST(plot, a_symmetric_axis_shows_small_values_of_both_signs_beside_large_ones) {
    Plot plot;
    plot.y.scale = Scale::symmetric_logarithmic;
    plot.curves = {{.name = "run", .x = {0, 1, 2, 3}, .y = {-1e-3, 1e-9, 0, 1}}};
    const Axis up = axes(plot, {0, 0, 300, 200}).up;
    // decades apart in value are far apart in pixels, and 0 lies between the signs
    EXPECT_GT(up.pixel(1e-9), up.pixel(1e-3) + 10);
    EXPECT_LT(up.pixel(1e-3), up.pixel(0) - 10);
    EXPECT_GT(up.pixel(-1e-3), up.pixel(0) + 10);
    for (const double value : {-1e-3, -1e-7, 0.0, 1e-9, 0.5})
        EXPECT_NEAR(up.value(up.pixel(value)), value, 1e-9 + 1e-3 * std::abs(value));
    EXPECT_EQ(ticks(up, 6).size() % 2, 1u) << "0, and the same powers on both sides where both are shown";
}

TEST(plot, the_axis_up_is_that_of_what_is_shown) {
    Plot plot = two_curves();
    plot.x.range = Range{0.05, 0.15};
    const Axes axes = plot::axes(plot, {0, 0, 100, 100});
    EXPECT_EQ(axes.across.low, 0.05);
    EXPECT_GT(axes.up.low, 0) << "2.5 alone lies within";
}

// A path that comes back to a column of pixels is not cut short there.
TEST(plot, a_path_keeps_all_that_its_columns_show) {
    std::vector<double> x, y;
    for (int i = 0; i <= 1000; ++i) {
        x.push_back(std::cos(0.0062831853 * i));
        y.push_back(std::sin(0.0062831853 * i));
    }
    const Axes axes{{-1, 1, Scale::linear, 0, 100}, {-1, 1, Scale::linear, 100, 0}};
    const auto points = decimated(x, y, axes);
    EXPECT_LE(points.size(), 4u * 220u) << "each of 100 columns is passed through twice";
    float lowest = 0, highest = 100;
    for (const Point& point : points) {
        lowest = std::max(lowest, point.y);
        highest = std::min(highest, point.y);
    }
    EXPECT_NEAR(lowest, 100, 0.1f);
    EXPECT_NEAR(highest, 0, 0.1f);
}

TEST(plot, one_exact_curve_lies_over_the_others_and_several_lie_under_them) {
    Plot plot;
    plot.curves = {{.name = "a"}, {.name = "exact", .colour = Curve::exact}, {.name = "b"}};
    EXPECT_EQ(drawing_order(plot), (std::vector<std::size_t>{0, 1, 2}));
    plot.curves.push_back({.name = "exact, too", .colour = Curve::exact});
    EXPECT_EQ(drawing_order(plot), (std::vector<std::size_t>{1, 3, 0, 2}));
}

TEST(plot, runs_are_told_apart_by_their_lines) {
    EXPECT_TRUE(dashes_of(line_of_run(0)).empty());
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < a; ++b) EXPECT_NE(line_of_run(a), line_of_run(b));
    }
}

Plot with_band(Scale scale) {
    Plot plot;
    plot.y.scale = scale;
    plot.curves = {{.name = "run", .x = {0, 1}, .y = {1, 1}}};
    plot.bands = {{.name = "spread", .x = {0, 1, 2}, .low = {0.5, -1, NAN}, .high = {2, 100, 3}}};
    return plot;
}

TEST(bands, have_two_columns_of_the_csv_and_room_on_the_axes) {
    const Plot plot = with_band(Scale::linear);
    EXPECT_EQ(csv(plot), "time,run,spread low,spread high\n0,1,0.5,2\n1,1,-1,100\n2,,,3\n");
    const Axes axes = plot::axes(plot, {0, 0, 100, 100});
    EXPECT_EQ(axes.across.high, 2);
    EXPECT_LE(axes.up.low, -1);
    EXPECT_GE(axes.up.high, 100);
}

TEST(bands, are_strips_from_low_to_high_and_end_where_a_logarithmic_axis_does) {
    const Box frame{0, 0, 100, 100};
    const Plot linear = with_band(Scale::linear), logarithmic = with_band(Scale::logarithmic);
    const Axes on_linear = axes(linear, frame), on_logarithmic = axes(logarithmic, frame);
    const auto found = strips(linear.bands.front(), on_linear);
    ASSERT_EQ(found.size(), 2u) << "the last place has no lower end";
    EXPECT_EQ(found[1].x, on_linear.across.pixel(1));
    EXPECT_EQ(found[1].top, on_linear.up.pixel(100));
    EXPECT_EQ(found[1].bottom, on_linear.up.pixel(-1));
    EXPECT_EQ(strips(logarithmic.bands.front(), on_logarithmic)[1].bottom, frame.bottom());
    EXPECT_EQ(strips(logarithmic.bands.front(), on_logarithmic)[0].bottom, on_logarithmic.up.pixel(0.5));
}

TEST(bands, of_many_points_keep_the_widest_extent_of_each_column) {
    Plot plot;
    Band band;
    for (int i = 0; i <= 10000; ++i) {
        band.x.push_back(i);
        band.low.push_back(i == 5003 ? -7 : -1);
        band.high.push_back(i == 5009 ? 9 : 1);
    }
    plot.bands = {band};
    const Axes axes = plot::axes(plot, {0, 0, 100, 100});
    const auto found = strips(band, axes);
    EXPECT_LE(found.size(), 102u);
    float top = 100, bottom = 0;
    for (const Strip& strip : found) {
        top = std::min(top, strip.top);
        bottom = std::max(bottom, strip.bottom);
    }
    EXPECT_EQ(top, axes.up.pixel(9));
    EXPECT_EQ(bottom, axes.up.pixel(-7));
}

}  // namespace
}  // namespace steplab::plot
