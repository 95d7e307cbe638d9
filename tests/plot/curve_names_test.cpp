#include "plot/curve_names.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace steplab::plot {
namespace {

constexpr float letter = 7;

const Lettering lettering{[](const std::string& text) { return letter * static_cast<float>(text.size()); }, 12, 1};

Plot crowded(int count) {
    Plot plot{.x = {.name = "cost", .scale = Scale::logarithmic}, .y = {.name = "error", .scale = Scale::logarithmic}};
    for (int number = 0; number < count; ++number) {
        Curve curve{.name = "method-" + std::to_string(number), .colour = static_cast<std::size_t>(number)};
        for (int i = 0; i < 6; ++i) curve.add(std::pow(10, i), (1 + 0.3 * number) * std::pow(10, -2 * i));
        plot.curves.push_back(curve);
    }
    return plot;
}

bool overlap(const Box& a, const Box& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

// Eleven curves that end next to each other.
TEST(curve_names, do_not_overlap_and_are_within_the_frame) {
    const Plot plot = crowded(11);
    const Layout layout = layout_of(plot, {0, 0, 600, 400}, lettering);
    const auto names = curve_names(plot, layout, lettering);
    ASSERT_EQ(names.size(), plot.curves.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Box& place = names[i].place;
        EXPECT_EQ(names[i].text, plot.curves[i].name);
        EXPECT_GE(place.width, letter * static_cast<float>(names[i].text.size()));
        EXPECT_TRUE(place.x >= layout.frame.x && place.right() <= layout.frame.right()) << names[i].text;
        EXPECT_TRUE(place.y >= layout.frame.y && place.bottom() <= layout.frame.bottom()) << names[i].text;
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(overlap(place, names[k].place)) << names[i].text << " on " << names[k].text;
    }
}

TEST(curve_names, quiet_curves_and_those_out_of_the_frame_have_none) {
    Plot plot = crowded(3);
    plot.curves[0].colour = Curve::quiet;
    plot.x.range = Range{1, 1e5};
    plot.y.range = Range{1e-12, 10};
    for (double& y : plot.curves[1].y) y *= 1e6 * 1e12;  // far above
    const auto names = curve_names(plot, layout_of(plot, {0, 0, 600, 400}, lettering), lettering);
    ASSERT_EQ(names.size(), 1u);
    EXPECT_EQ(names[0].text, "method-2");
}

}  // namespace
}  // namespace steplab::plot
