#include "plot/layout.hpp"

#include "support/extreme_doubles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace steplab::plot {
namespace {

/// Letters as wide as those of the usual font, in a window of some scale.
Lettering letters(float scale) {
    return {[scale](const std::string& text) { return 7 * scale * static_cast<float>(text.size()); }, 13 * scale,
            scale};
}

Plot line_between(double x0, double x1, double y0, double y1, Scale scale) {
    Plot plot;
    plot.y.scale = scale;
    Curve curve;
    curve.x = {x0, x1};
    curve.y = {y0, y1};
    plot.curves = {curve};
    return plot;
}

/// What is wrong with the labels of a layout; empty if nothing is.
std::string complaint(const Layout& layout, const Box& area) {
    for (const auto* ticks : {&layout.up, &layout.across}) {
        const Box* last = nullptr;
        for (const PlacedTick& tick : *ticks) {
            if (!std::isfinite(tick.pixel)) return "a tick at no pixel";
            if (tick.label.empty()) continue;
            const Box& place = tick.place;
            if (place.x < area.x || place.right() > area.right() || place.y < area.y || place.bottom() > area.bottom())
                return "outside: " + tick.label;
            const bool apart = !last || place.x >= last->right() || last->x >= place.right() ||
                               place.y >= last->bottom() || last->y >= place.bottom();
            if (!apart) return "overlaps the one before: " + tick.label;
            last = &place;
        }
    }
    return {};
}

constexpr Box usual{310, 582, 475, 208};
constexpr Box narrow{10, 40, 240, 130};

TEST(plot_layout, labels_of_any_values_stay_in_the_plot_and_apart) {
    const Lettering lettering = letters(1);
    for (const auto& [a, b] : extreme_pairs(2000)) {
        for (const Scale scale : {Scale::linear, Scale::logarithmic, Scale::symmetric_logarithmic}) {
            for (const Box& area : {usual, narrow}) {
                const Layout up = layout_of(line_between(0, 1, a, b, scale), area, lettering);
                ASSERT_EQ(complaint(up, area), "") << a << " .. " << b;
                const Layout across = layout_of(line_between(a, b, 0.5, 1, scale), area, lettering);
                ASSERT_EQ(complaint(across, area), "") << a << " .. " << b;
                ASSERT_GT(up.frame.width, 0.3f * area.width);
            }
        }
    }
}

TEST(plot_layout, labels_stay_in_a_plot_of_any_size_and_scale) {
    for (const float scale : {0.5f, 1.0f, 1.25f, 2.0f, 4.0f}) {
        const Lettering lettering = letters(scale);
        for (float width = 240; width < 1500; width += 37) {
            const Box area{3, 5, width * scale, (120 + 0.2f * width) * scale};
            for (const double time : {0.001, 7.0, 9999.9, 123456.7}) {
                const Plot plot = line_between(0, time, -1.2345e-14, 9.87e-13, Scale::linear);
                ASSERT_EQ(complaint(layout_of(plot, area, lettering), area), "") << width << " " << time;
            }
        }
    }
}

TEST(plot_layout, wide_labels_move_the_frame_and_usual_ones_do_not) {
    const Lettering lettering = letters(1);
    const float few = layout_of(line_between(0, 10, 0, 4, Scale::linear), usual, lettering).frame.x;
    const float many = layout_of(line_between(0, 10, -1.2345e-142, 1e-142, Scale::linear), usual, lettering).frame.x;
    EXPECT_EQ(few, usual.x + 52);
    EXPECT_GT(many, few);
}

TEST(plot_layout, usual_ranges_keep_all_their_labels) {
    const Lettering lettering = letters(1);
    const Layout layout = layout_of(line_between(0, 15.8, -2, 6, Scale::linear), usual, lettering);
    EXPECT_GE(layout.up.size(), 4u);
    EXPECT_GE(layout.across.size(), 3u);
    for (const PlacedTick& tick : layout.across) EXPECT_FALSE(tick.label.empty());
    for (const PlacedTick& tick : layout.up) EXPECT_FALSE(tick.label.empty());
}

TEST(plot_layout, an_axis_across_has_two_numbers_at_least) {
    for (const Box& area : {usual, narrow}) {
        for (double half = 0.1; half < 1; half += 0.013) {
            const Layout layout = layout_of(line_between(-half, half, 0, 1, Scale::linear), area, letters(1));
            EXPECT_EQ(complaint(layout, area), "");
            const auto count = std::count_if(layout.across.begin(), layout.across.end(),
                                             [](const PlacedTick& tick) { return !tick.label.empty(); });
            EXPECT_GE(count, 2) << half;
        }
    }
}

TEST(plot_layout, curves_of_any_values_stay_near_the_frame) {
    const Lettering lettering = letters(1);
    for (const auto& [a, b] : extreme_pairs(2000)) {
        for (const Scale scale : {Scale::linear, Scale::logarithmic, Scale::symmetric_logarithmic}) {
            const Plot plot = line_between(0, 1, a, b, scale);
            if (!has_values(plot)) continue;  // nothing is drawn
            const Layout layout = layout_of(plot, usual, lettering);
            const auto& [across, up] = layout.axes;
            for (const Point& point : decimated(plot.curves[0].x, plot.curves[0].y, layout.axes)) {
                // The axes hold all values, up to the rounding of the ends of a range.
                ASSERT_GE(point.y, layout.frame.y - 1) << a << " .. " << b;
                ASSERT_LE(point.y, layout.frame.bottom() + 1) << a << " .. " << b;
            }
            for (const double value : special_doubles()) {
                ASSERT_TRUE(std::isfinite(up.pixel(value)));
                ASSERT_TRUE(std::isfinite(across.pixel(value)));
            }
            ASSERT_FALSE(std::isnan(up.value(layout.frame.y)));
        }
    }
}

}  // namespace
}  // namespace steplab::plot
