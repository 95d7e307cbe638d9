#include "plot/moment_labels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace steplab::plot {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Lettering eight_wide{[](const std::string& text) { return 8 * static_cast<float>(text.size()); }, 12, 1};

/// Moments in time, in a plot of 0 to 10 s.
struct Marked {
    explicit Marked(std::vector<Moment> moments, float width = 468, float height = 300) {
        plot.x.range = Range{0, 10};
        plot.curves = {{.name = "run", .x = {0, 10}, .y = {0, 1}}};
        plot.moments = std::move(moments);
        layout = layout_of(plot, {0, 0, width, height}, eight_wide);
        lines = moment_lines(plot, layout, eight_wide);
    }
    /// The row that each label has from below; -1: none.
    std::vector<int> rows() const {
        std::vector<int> all;
        for (const MomentLine& line : lines)
            all.push_back(line.label.empty() ? -1
                                             : static_cast<int>((layout.frame.bottom() - line.label.bottom()) / 14));
        return all;
    }

    Plot plot;
    Layout layout;
    std::vector<MomentLine> lines;
};

TEST(moment_labels, stand_in_the_lowest_row_where_they_do_not_meet) {
    EXPECT_THAT(Marked({{1, "dt 1"}, {4, "dt 2"}, {7, "dt 3"}}).rows(), ElementsAre(0, 0, 0));
    EXPECT_THAT(Marked({{4, "dt 1"}, {4.1, "dt 2"}, {4.2, "dt 3"}}).rows(), ElementsAre(2, 1, 0));
    EXPECT_THAT(Marked({{1, "dt 1"}, {4.1, "dt 2"}, {4.2, "dt 3"}}).rows(), ElementsAre(0, 1, 0));
}

TEST(moment_labels, are_those_of_the_last_where_not_all_have_room) {
    EXPECT_THAT(Marked({{3, "a"}, {3.1, "b"}, {3.1, "c"}, {3.1, "d"}, {3.2, "e"}}).rows(),
                ElementsAre(-1, -1, 2, 1, 0));
    // a low frame has one row
    EXPECT_THAT(Marked({{4, "dt 1"}, {4.1, "dt 2"}, {4.2, "dt 3"}}, 468, 120).rows(), ElementsAre(-1, -1, 0));
}

TEST(moment_labels, stand_left_of_their_lines_where_the_frame_ends) {
    const Marked marked({{9.9, "dt 0.25"}});
    EXPECT_EQ(marked.lines[0].label.right(), marked.lines[0].pixel);
    const Marked in_the_middle({{5, "dt 0.25"}});
    EXPECT_EQ(in_the_middle.lines[0].label.x, in_the_middle.lines[0].pixel);
}

TEST(moment_labels, of_any_number_lie_in_the_frame_and_apart) {
    std::vector<Moment> moments;
    for (int i = -3; i < 80; ++i) moments.push_back({0.13 * i * i / 8, "mode " + std::to_string(i)});
    for (const float width : {80.0F, 200.0F, 700.0F}) {
        const Marked marked(moments, width);
        int labels = 0;
        for (const MomentLine& a : marked.lines) {
            if (a.label.empty()) continue;
            ++labels;
            const Box& frame = marked.layout.frame;
            EXPECT_GE(a.label.x, frame.x);
            EXPECT_LE(a.label.right(), frame.right());
            EXPECT_LE(a.label.bottom(), frame.bottom());
            EXPECT_GE(a.label.y, frame.bottom() - frame.height / 4);
            for (const MomentLine& b : marked.lines) EXPECT_FALSE(&a != &b && a.label.meets(b.label));
        }
        EXPECT_EQ(labels > 0, width > 80) << "in the narrowest frame there is no room for one";
    }
}

TEST(moment_labels, lines_that_the_frame_does_not_show_are_left_out) {
    const Marked marked({{-1, "before"}, {2, "shown"}, {11, "after"}});
    ASSERT_EQ(marked.lines.size(), 1u);
    EXPECT_EQ(marked.lines[0].moment->text, "shown");
}

TEST(moment_labels, have_a_height_that_other_things_leave_free) {
    const Marked two({{4, "dt 1"}, {4.1, "dt 2"}}), none({});
    EXPECT_EQ(height_of_labels(two.lines, two.layout.frame), 28);
    EXPECT_EQ(height_of_labels(none.lines, none.layout.frame), 0);
}

TEST(moment_labels, a_pointer_is_told_of_each_line_that_it_is_at) {
    const Marked marked({{2, "dt 1"}, {2, "rk4"}, {8, "dt 2"}});
    const auto at = [&](float pixel) {
        std::vector<std::string> texts;
        for (const Moment* moment : moments_at(marked.plot, marked.layout.axes, pixel, 3))
            texts.push_back(moment->text);
        return texts;
    };
    const float first = marked.lines[0].pixel;
    EXPECT_THAT(at(first), ElementsAre("dt 1", "rk4"));
    EXPECT_THAT(at(first - 2), ElementsAre("dt 1", "rk4"));
    EXPECT_THAT(at(first + 5), IsEmpty());
    EXPECT_THAT(at(marked.lines[2].pixel), ElementsAre("dt 2"));
}

}  // namespace
}  // namespace steplab::plot
