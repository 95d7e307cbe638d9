#include "plot/svg.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace steplab::plot {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Plot two_drawn_curves() {
    Plot plot;
    plot.curves = {{.name = "run", .x = {0, 0.1, 0.2}, .y = {1, 2.5, -3}},
                   {.name = "exact", .colour = Curve::exact, .x = {0, 0.1, 0.2}, .y = {1, NAN, -3.125}}};
    return plot;
}

TEST(svg, holds_title_axes_curves_and_caption) {
    Plot plot = two_drawn_curves();
    plot.title = "E < E0 & more";
    plot.caption = "chain, rk4";
    plot.moments = {{0.1, "dt 0.2"}};
    const std::string text = svg(plot);
    for (const char* const part :
         {"E &lt; E0 &amp; more", "chain, rk4", "time [s]", "<title>run</title>", "dt 0.2", "polyline"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    EXPECT_EQ(text, svg(plot)) << "the same bytes each time";
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
}

TEST(svg, of_extreme_values_holds_numbers_only) {
    constexpr double largest = std::numeric_limits<double>::max();
    for (const double value : {0.0, 5e-324, 1e-300, 1.0, largest, -largest, std::numeric_limits<double>::infinity()}) {
        for (const Scale scale : {Scale::linear, Scale::logarithmic, Scale::symmetric_logarithmic}) {
            Plot plot;
            plot.y.scale = scale;
            plot.curves = {{.name = "run", .x = {0, 1}, .y = {value, 1}}};
            const std::string text = svg(plot);
            EXPECT_EQ(text.find("nan"), std::string::npos) << value;
            EXPECT_EQ(text.find("inf"), std::string::npos) << value;
        }
    }
}

Curve falling(const std::string& name, double shift, std::size_t colour) {
    Curve curve{.name = name, .colour = colour, .ascending = false};
    for (int i = 0; i < 6; ++i) curve.add(std::pow(10, i), shift * std::pow(10, -2 * i));
    return curve;
}

Plot logarithmic(std::vector<Curve> curves) {
    return {.x = {.name = "cost", .scale = Scale::logarithmic},
            .y = {.name = "error", .unit = "m", .scale = Scale::logarithmic},
            .curves = std::move(curves)};
}

const Inks page{"var(--card)",
                "var(--ink)",
                "var(--faint)",
                "var(--line)",
                "var(--exact)",
                "var(--quiet)",
                {"var(--c0)", "var(--c1)"}};

/// As XML parsers require: blanks between attributes, and as many opening as closing tags.
bool is_well_formed(const std::string& svg) {
    const auto count = [&](const char* pattern) {
        const std::regex tag(pattern);
        return std::distance(std::sregex_iterator(svg.begin(), svg.end(), tag), std::sregex_iterator());
    };
    return count("[\"'][a-z:-]+=") == 0 && count("<[a-zA-Z]") == count("</[a-zA-Z]") + count("/>");
}

TEST(svg, is_well_formed_xml) {
    Plot plot = logarithmic({falling("rk4 < euler", 1, 0), falling("euler", 2, Curve::quiet)});
    plot.bands = {{.name = "spread", .x = {1, 10}, .low = {0.1, 0.1}, .high = {1, 2}}};
    EXPECT_TRUE(is_well_formed(svg(plot)));
    EXPECT_TRUE(is_well_formed(svg_element(plot, page)));
    EXPECT_FALSE(is_well_formed("<g fill='red'font-size='12'></g>"));
    EXPECT_FALSE(is_well_formed("<g><path/>"));
}

TEST(svg, element_of_a_page_has_a_group_and_a_name_for_each_curve_and_the_colours_of_the_page) {
    const std::string text = svg_element(
        logarithmic({falling("rk4", 1, 1), falling("euler by tolerance", 2, 0), falling("verlet", 3, Curve::quiet)}),
        page);
    EXPECT_THAT(text, StartsWith("<svg"));
    EXPECT_THAT(text, HasSubstr("class=\"curve\" data-name=\"rk4\" stroke=\"var(--c1)\""));
    EXPECT_THAT(text,
                HasSubstr("data-name=\"euler\" stroke=\"var(--c0)\" fill=\"var(--c0)\"><title>euler by tolerance"));
    EXPECT_THAT(text, HasSubstr(">rk4</text>"));
    EXPECT_THAT(text, Not(HasSubstr(">verlet</text>")));  // quiet: its name is shown where the pointer is
    EXPECT_THAT(text, HasSubstr("<title>verlet</title>"));
    EXPECT_THAT(text, Not(HasSubstr("=\"#")));
    // names of elements would have to be unique in the page
    EXPECT_THAT(text, Not(HasSubstr("id=")));
}

TEST(svg, quiet_curves_lie_behind_the_others_and_have_no_dots) {
    const std::string text = svg_element(logarithmic({falling("rk4", 1, 0), falling("euler", 2, Curve::quiet)}), page);
    EXPECT_LT(text.find("data-name=\"euler\""), text.find("data-name=\"rk4\""));
    EXPECT_LT(text.find("data-name=\"rk4\""), text.find("<circle"));
    EXPECT_THAT(svg_element(logarithmic({falling("euler", 2, Curve::quiet)}), page), Not(HasSubstr("<circle")));
}

// No curve at all, or none with a point that a logarithmic axis can show.
TEST(svg, element_of_a_plot_without_a_point_is_empty) {
    const Curve zero{.name = "zero", .x = {1, 2, 3}, .y = {0, -1, INFINITY}};
    EXPECT_EQ(svg_element(logarithmic({}), page), "");
    EXPECT_EQ(svg_element(logarithmic({zero}), page), "");
    const std::string both = svg_element(logarithmic({falling("rk4", 1, 0), zero}), page);
    EXPECT_THAT(both, HasSubstr("rk4"));
    EXPECT_THAT(both, Not(HasSubstr("zero")));
}

/// The left upper corner of the card of the legend, which is the only rectangle that is not opaque.
std::pair<float, float> legend_corner(const std::string& text) {
    const std::size_t end = text.find("fill-opacity=\"0.8\"");
    const std::size_t begin = text.rfind("<rect x=\"", end);
    float x = 0, y = 0;
    if (end != std::string::npos) std::sscanf(text.c_str() + begin, "<rect x=\"%f\" y=\"%f\"", &x, &y);
    return {x, y};
}

TEST(svg, legend_lies_where_the_curves_are_not) {
    Plot plot;
    plot.curves = {{.name = "one", .x = {0, 1, 2}, .y = {0, 0.2, 3}},
                   {.name = "two", .x = {0, 1, 2}, .y = {0, 0.1, 3}}};
    EXPECT_LT(legend_corner(svg(plot)).first, 360) << "they rise to the right";
    for (Curve& curve : plot.curves) std::reverse(curve.y.begin(), curve.y.end());
    EXPECT_GT(legend_corner(svg(plot)).first, 360) << "they fall";
    EXPECT_LT(legend_corner(svg(plot)).second, 220);
}

/// Ends of the lines of this colour, as x1, y1, x2, y2.
std::vector<std::array<float, 4>> lines_in(const std::string& text, const std::string& colour) {
    std::vector<std::array<float, 4>> lines;
    const std::regex line("<line x1=\"(.*?)\" y1=\"(.*?)\" x2=\"(.*?)\" y2=\"(.*?)\" stroke=\"" + colour + "\"/>");
    for (std::sregex_iterator it(text.begin(), text.end(), line); it != std::sregex_iterator(); ++it)
        lines.push_back({std::stof((*it)[1]), std::stof((*it)[2]), std::stof((*it)[3]), std::stof((*it)[4])});
    return lines;
}

TEST(svg, each_grid_line_has_a_tick_outside_the_frame) {
    const std::string text = svg(two_drawn_curves());
    const auto grid = lines_in(text, "#dfe4ea"), ticks = lines_in(text, "#9aa5b1");
    ASSERT_GT(grid.size(), 5u);
    ASSERT_EQ(grid.size(), ticks.size());
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const auto [x1, y1, x2, y2] = grid[i];
        const std::array<float, 4> outside = y1 == y2 ? std::array{x1 - 3, y1, x1, y1} : std::array{x1, y2, x1, y2 + 3};
        EXPECT_EQ(ticks[i], outside);
    }
}

TEST(svg, legend_names_curves_and_bands_but_not_those_that_are_left_out_of_it) {
    Plot plot = two_drawn_curves();
    plot.bands = {{.name = "spread", .x = {0, 0.2}, .low = {-1, -1}, .high = {1, 1}}};
    plot.curves[1].in_legend = false;
    const std::string text = svg(plot);
    EXPECT_THAT(text, HasSubstr(">run</text>"));
    EXPECT_THAT(text, HasSubstr(">spread</text>"));
    EXPECT_THAT(text, Not(HasSubstr(">exact</text>")));
}

}  // namespace
}  // namespace steplab::plot
