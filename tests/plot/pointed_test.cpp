#include "plot/pointed.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::plot {
namespace {

/// A pixel is worth 0.1.
constexpr Axes pointed_axes{{0, 10, Scale::linear, 0, 100}, {0, 10, Scale::linear, 100, 0}};

Plot short_and_long() {
    Plot plot;
    plot.curves = {{.name = "long", .x = {0, 5, 10}, .y = {1, 2, 3}},
                   {.name = "short", .x = {4, 5, 6}, .y = {1, 2, 3}}};
    plot.bands = {{.name = "band", .x = {4, 6}, .low = {0, 0}, .high = {1, 1}}};
    return plot;
}

TEST(pointed, curves_have_a_value_only_where_they_reach) {
    const Plot plot = short_and_long();
    const auto both = points_at(plot, pointed_axes, {52, 50});
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0].index, 1u);
    EXPECT_EQ(both[1].index, 1u);
    for (const float beside : {0.0f, 35.0f, 65.0f, 100.0f}) {
        const auto one = points_at(plot, pointed_axes, {beside, 50});
        ASSERT_EQ(one.size(), 1u) << beside;
        EXPECT_EQ(one[0].curve->name, "long");
        EXPECT_FALSE(place_at(plot.bands[0], pointed_axes, {beside, 50})) << beside;
    }
    // the ends are met to a pixel
    EXPECT_EQ(points_at(plot, pointed_axes, {39.5f, 50}).size(), 2u);
    EXPECT_EQ(points_at(plot, pointed_axes, {60.5f, 50}).size(), 2u);
    EXPECT_EQ(place_at(plot.bands[0], pointed_axes, {59, 50}), 1u);
}

TEST(pointed, a_gap_has_no_value) {
    Plot plot = short_and_long();
    plot.curves[0].y[1] = NAN;
    EXPECT_EQ(points_at(plot, pointed_axes, {50, 50}).size(), 1u);
}

TEST(pointed, of_a_path_it_is_the_nearest_point) {
    Plot plot;
    plot.curves = {{.name = "path", .ascending = false, .x = {5, 1, 9}, .y = {5, 1, 1}}};
    const auto found = points_at(plot, pointed_axes, {80, 80});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].index, 2u);
}

}  // namespace
}  // namespace steplab::plot
