#include "lab/report/figure.hpp"

#include "core/entry.hpp"
#include "lab/report/curve_labels.hpp"
#include "lab/report/page.hpp"
#include "lab/report/svg.hpp"
#include "lab/report/ticks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <regex>
#include <string>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::Not;

Curve falling(const std::string& name, double shift, std::optional<int> colour) {
    Curve curve{.name = name, .points = {}, .colour = colour};
    for (int i = 0; i < 6; ++i) curve.points.emplace_back(std::pow(10, i), shift * std::pow(10, -2 * i));
    return curve;
}

Figure figure(std::vector<Curve> curves) {
    return {.x = {.label = "x"}, .y = {.label = "y"}, .curves = std::move(curves)};
}

TEST(Figure, is_an_svg_element_with_a_group_for_each_curve) {
    const auto svg = svg_figures(std::vector{figure({falling("rk4", 1, 0), falling("euler", 2, {})})});
    ASSERT_EQ(svg.size(), 1u);
    EXPECT_THAT(svg[0], testing::StartsWith("<svg"));
    EXPECT_THAT(svg[0], HasSubstr("data-method=\"rk4\"><title>rk4</title>"));
    EXPECT_THAT(svg[0], HasSubstr("data-method=\"euler\""));
    EXPECT_THAT(svg[0], HasSubstr("var(--c16)"));
    EXPECT_THAT(svg[0], Not(HasSubstr("rgb(")));
}

// Curves and figures without a point that can be drawn on logarithmic axes: gnuplot would warn or fail.
/// As XML parsers require: blanks between attributes, and as many opening as closing tags.
bool is_well_formed(const std::string& svg) {
    const auto count = [&](const char* pattern) {
        const std::regex tag(pattern);
        return std::distance(std::sregex_iterator(svg.begin(), svg.end(), tag), std::sregex_iterator());
    };
    return count("[\"'][a-z:-]+=") == 0 && count("<[a-z]") == count("</[a-z]") + count("/>");
}

TEST(Figure, is_well_formed_xml) {
    const std::string svg = svg_file(svg_figures(std::vector{figure({falling("rk4", 1, 0)})}).front());
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_THAT(svg, Not(HasSubstr("var(")));
    EXPECT_FALSE(is_well_formed("<g fill='red'font-size='12'></g>"));
    EXPECT_FALSE(is_well_formed("<g><path/>"));
}

TEST(Figure, without_a_point_is_empty_and_does_not_affect_others) {
    Curve zero{.name = "zero", .points = {{1, 0}, {2, -1}, {3, infinity}}};
    testing::internal::CaptureStderr();
    const auto svg = svg_figures(std::vector{figure({zero}), figure({falling("rk4", 1, 0), zero}), figure({})});
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(svg[0], "");
    EXPECT_THAT(svg[1], HasSubstr("rk4"));
    EXPECT_EQ(svg[2], "");
}

// Eleven names whose curves end next to each other: no two overlap, all are within the frame.
TEST(CurveLabels, do_not_overlap_and_are_within_the_frame) {
    std::vector<Curve> curves;
    for (int i = 0; i < 11; ++i) curves.push_back(falling("method-" + std::to_string(i), 1 + 0.3 * i, i));
    const Figure crowded = figure(curves);
    const auto labels = curve_labels(crowded, *range_of(curves, true, true), *range_of(curves, false, true));
    ASSERT_EQ(labels.size(), curves.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_GE(labels[i].x, FigureArea::left);
        EXPECT_LE(labels[i].x, FigureArea::right - 40);
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_TRUE(std::abs(labels[i].y - labels[k].y) > 11 || std::abs(labels[i].x - labels[k].x) > 50)
                << labels[i].text << " on " << labels[k].text;
        }
    }
}

TEST(Ticks, are_decades_in_words) {
    const auto seconds = decades({2e-7, 2e-3}, Quantity::seconds);
    ASSERT_EQ(seconds.size(), 4u);
    EXPECT_EQ(seconds[0].text, "1 µs");
    EXPECT_EQ(seconds[3].text, "1 ms");
    EXPECT_EQ(decades({0.5, 2e6}, Quantity::count).back().text, "1\u202f000\u202f000");
    EXPECT_EQ(decades({1e-7, 1e-5}, Quantity::number).front().text, "10⁻⁷");
}

TEST(Ticks, leave_out_texts_where_there_is_no_room) {
    std::size_t texts = 0;
    for (const Tick& tick : decades({1e-16, 1e2}, Quantity::number)) texts += tick.text.empty() ? 0 : 1;
    EXPECT_LE(texts, 10u);
    EXPECT_GE(texts, 5u);
}

TEST(PageSvg, is_empty_where_there_is_no_picture) {
    EXPECT_EQ(page_svg("", {}), "");
    EXPECT_EQ(page_svg("gnuplot failed", {}), "");
}

}  // namespace
}  // namespace steplab::test
