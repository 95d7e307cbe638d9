#include "render/axes.hpp"

#include "render/occupancy.hpp"
#include "render/overlay.hpp"
#include "support/extreme_doubles.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace steplab::render {
namespace {

const AxesBox box{{{0, -1, -18}, {18, 3, 0}}, 2};
const PictureSize size_of_axes{1280, 720};

bool has_label(const Axes& axes, const std::string& text) {
    return std::any_of(axes.labels.begin(), axes.labels.end(), [&](const AxisLabel& l) { return l.text == text; });
}

Axes seen_from(double yaw, double pitch) {
    return axes_of(box, Projection({{9, 1, -9}, 60, yaw, pitch}, size_of_axes), 1);
}

TEST(Axes, have_titles_with_units_and_numbers) {
    const Axes axes = seen_from(30, 30);
    for (const char* text : {"x [m]", "y [m]", "z [m]", "0", "10"}) EXPECT_TRUE(has_label(axes, text)) << text;
}

TEST(Axes, the_one_seen_from_its_end_is_left_out) {
    EXPECT_FALSE(has_label(seen_from(0, 0), "z [m]"));
    EXPECT_FALSE(has_label(seen_from(90, 0), "x [m]"));
    EXPECT_FALSE(has_label(seen_from(30, 90), "y [m]"));
}

TEST(Axes, lie_on_the_side_that_faces_the_eye_and_seen_from_below_on_the_far_one) {
    const auto z_of_x_axis = [](const Axes& axes) { return axes.lines.front().start.z; };
    EXPECT_EQ(z_of_x_axis(seen_from(20, 30)), box.bounds.high.z);
    EXPECT_EQ(z_of_x_axis(seen_from(160, 30)), box.bounds.low.z);
    EXPECT_EQ(z_of_x_axis(seen_from(20, -30)), box.bounds.low.z);
    EXPECT_EQ(z_of_x_axis(seen_from(160, -30)), box.bounds.high.z);
}

/// The labels of axes that are seen level, at the edge of a picture, are within it and lie on no other.
TEST(Axes, texts_at_the_edge_of_the_picture_are_not_cut) {
    const PixelPoint text{34, 16};
    for (const PictureSize picture : {PictureSize{980, 500}, {500, 420}, {320, 260}}) {
        SCOPED_TRACE(picture.width);
        for (const double yaw : {0.0, 90.0, -90.0, 180.0}) {
            // The side of the box that faces the eye fills nine tenths of the picture.
            const double distance = 9 + 10 / Projection({{9, 1, -9}, 1, yaw, 0}, picture).half_width();
            const Axes axes = axes_of(box, Projection({{9, 1, -9}, distance, yaw, 0}, picture), 1);
            EXPECT_TRUE(has_label(axes, "y [m]"));
            for (const AxisLabel& label : axes.labels) {
                const PixelPoint low = place_of(label, text, picture);
                EXPECT_GE(low.x, 0) << label.text;
                EXPECT_LE(low.x + text.x, picture.width) << label.text;
                EXPECT_GE(low.y, 0) << label.text;
                EXPECT_LE(low.y + text.y, picture.height) << label.text;
                for (const AxisLabel& other : axes.labels) {
                    const PixelPoint there = place_of(other, text, picture);
                    const bool apart = std::abs(there.x - low.x) >= text.x || std::abs(there.y - low.y) >= text.y;
                    EXPECT_TRUE(&other == &label || apart || label.text != "y [m]") << other.text;
                }
            }
        }
    }
}

TEST(Axes, texts_of_an_axis_outside_the_picture_stay_there) {
    const AxisLabel number{"3", {-40, 100}, 1};
    EXPECT_EQ(place_of(number, {10, 16}, size_of_axes).x, -45);
    const AxisLabel title{"y [m]", {-40, 100}, 1};
    EXPECT_LT(place_of(title, {34, 16}, size_of_axes).x, 0);
}

/// How far a point is from the line of an axis in the picture, in pixels; negative on its other side.
double beside(const AxisLine& axis, Vec3 point, const Projection& projection) {
    const PixelPoint start = *projection.pixel(axis.start), end = *projection.pixel(axis.end);
    const PixelPoint at = *projection.pixel(point);
    const double across = (end.x - start.x) * (at.y - start.y) - (end.y - start.y) * (at.x - start.x);
    return across / std::hypot(end.x - start.x, end.y - start.y);
}

/// An axis ends at a corner of the box and is followed by its ticks.
void expect_ticks_outside(const Projection& projection, const std::vector<Vec3>& inside) {
    constexpr double rounding = 1e-9;  // of pixels up to 1e4, in double
    const AxisLine* axis = nullptr;
    const Axes axes = axes_of(box, projection, 1);
    for (const AxisLine& line : axes.lines) {
        const auto corners = box.bounds.corners();
        const bool is_axis = std::find(corners.begin(), corners.end(), line.end) != corners.end();
        if (is_axis) axis = &line;
        if (is_axis) continue;
        const double tick = beside(*axis, line.end, projection);
        EXPECT_NEAR(std::abs(tick), 5, rounding) << "across the axis and as long in every view";
        for (const Vec3 point : inside) EXPECT_LE(beside(*axis, point, projection) * tick, 5 * rounding);
    }
    EXPECT_NE(axis, nullptr);
}

void expect_ticks_outside(double yaw, double pitch, const std::vector<Vec3>& inside) {
    SCOPED_TRACE(testing::Message() << yaw << ", " << pitch);
    expect_ticks_outside(Projection({{9, 1, -9}, 60, yaw, pitch}, size_of_axes), inside);
}

// In these views all of the box lies inwards of the edges of its floor. Seen straight on or steeply, its sides lie
// outwards.
TEST(Axes, ticks_point_away_from_the_box) {
    const auto corners = box.bounds.corners();
    for (int yaw = -165; yaw < 180; yaw += 30) {
        for (int pitch = -45; pitch <= 45; pitch += 15)
            expect_ticks_outside(yaw, pitch, {corners.begin(), corners.end()});
    }
}

TEST(Axes, ticks_point_away_from_the_floor_in_every_view) {
    const auto [low, high] = box.bounds;
    for (int yaw = -180; yaw < 180; yaw += 15) {
        for (int pitch = -90; pitch <= 90; pitch += 15)
            expect_ticks_outside(yaw, pitch,
                                 {low, {high.x, low.y, low.z}, {low.x, low.y, high.z}, {high.x, low.y, high.z}});
    }
}

TEST(Axes, ticks_point_down_from_a_floor_that_is_seen_edge_on) {
    const Projection projection({{9, box.bounds.low.y, -9}, 60, 20, 0}, size_of_axes);
    const AxisLine tick_of_x = axes_of(box, projection, 1).lines.at(1);
    EXPECT_EQ(tick_of_x.start.y, box.bounds.low.y);
    EXPECT_LT(tick_of_x.end.y, box.bounds.low.y);
}

TEST(Axes, numbers_keep_their_distance) {
    // Seen from four times as far, there is room for fewer numbers.
    const auto far = axes_of(box, Projection({{9, 1, -9}, 240, 30, 30}, size_of_axes), 1);
    EXPECT_LT(far.labels.size(), seen_from(30, 30).labels.size());
}

TEST(Axes, behind_the_eye_there_are_none) {
    EXPECT_TRUE(axes_of(box, Projection({{9, 1, 500}, 60, 0, 0}, size_of_axes), 1).labels.empty());
}

std::ptrdiff_t strong(const Axes& axes) {
    return std::count_if(axes.lines.begin(), axes.lines.end(), [](const AxisLine& line) { return line.strength == 1; });
}

TEST(BoxEdges, are_twelve_of_the_lengths_of_the_sides) {
    Shape shape;
    shape.box = {3, 4, 5};
    shape.corner = {-1, 0, 2};
    Axes axes;
    add_box_edges(axes, shape, {});
    ASSERT_EQ(axes.lines.size(), 12u);
    EXPECT_EQ(strong(axes), 12);
    double sum = 0;
    for (const AxisLine& line : axes.lines) sum += length(line.end - line.start);
    EXPECT_EQ(sum, 4 * (3 + 4 + 5));
}

// Open along y: its four edges are as long as what is drawn, and only the lower end has edges across.
TEST(BoxEdges, of_an_open_box_close_it_at_its_lower_end_alone) {
    Shape shape;
    shape.box = {3, 0, 5};
    Axes axes;
    add_box_edges(axes, shape, {{0, -2, 0}, {3, 7, 5}});
    EXPECT_EQ(axes.lines.size(), 8u);
    EXPECT_EQ(strong(axes), 4);
    for (const AxisLine& line : axes.lines) {
        if (line.strength == 1) {
            EXPECT_EQ(length(line.end - line.start), 9);
        } else {
            EXPECT_EQ(line.start.y, -2);
            EXPECT_EQ(line.end.y, -2);
        }
    }
}

TEST(BoxEdges, of_a_cell_lean_as_it_does) {
    Axes axes;
    const Cell cell{{Vec3{3, 0, 0}, Vec3{1, 4, 0}, Vec3{0, 1, 5}}, {-1, 0, 2}, {true, true, true}};
    add_cell_edges(axes, cell);
    ASSERT_EQ(axes.lines.size(), 12u);
    for (const Vec3& edge : cell.edges) {
        EXPECT_EQ(std::count_if(axes.lines.begin(), axes.lines.end(),
                                [&](const AxisLine& line) { return line.end - line.start == edge; }),
                  4);
    }
    EXPECT_EQ(axes.lines.front().start, cell.corner);
}

TEST(BoxEdges, of_a_scene_without_box_are_none) {
    Axes axes;
    add_box_edges(axes, Shape{}, {{0, 0, 0}, {1, 1, 1}});
    EXPECT_TRUE(axes.lines.empty());
}

TEST(Occupancy, is_the_covered_part_of_a_rectangle) {
    Occupancy taken({320, 160});
    EXPECT_EQ(taken.taken({0, 0}, {319, 159}), 0);
    taken.mark({100, 80}, 10);
    EXPECT_EQ(taken.taken({95, 75}, {105, 85}), 1);
    EXPECT_EQ(taken.taken({200, 75}, {220, 85}), 0);
    const double part = taken.taken({100, 75}, {180, 85});
    EXPECT_GT(part, 0);
    EXPECT_LT(part, 1);
}

TEST(Axes, of_any_box_are_few_lines_and_labels) {
    for (const auto& [a, b] : extreme_pairs(1000)) {
        if (!(std::abs(a) < 1e100 && std::abs(b) < 1e100) || b < a) continue;  // drawable()
        const Bounds bounds = bounds_of(std::vector<Vec3>{{a, 0, a}, {b, b, 1}});
        const AxesBox any = axes_box(bounds, 1e-3 * std::abs(b), bounds);
        const double reach = std::clamp(length(any.bounds.size()), 1e-99, 1e99);
        for (const Camera& camera :
             {Camera{any.bounds.centre(), reach, 30, 30}, Camera{{a, 0, 0}, 1e-9 * reach, 0, 0}}) {
            const Axes axes = axes_of(any, Projection(camera, size_of_axes), 1);
            ASSERT_LE(axes.labels.size(), 3 * 1002u) << a << " .. " << b;
            for (const AxisLabel& label : axes.labels) {
                ASSERT_TRUE(label.strength > 0 && label.strength <= 1);
                ASSERT_LE(label.text.size(), 40u);
            }
            for (const AxisLine& line : axes.lines) ASSERT_TRUE(line.strength > 0 && line.strength <= 1);
        }
    }
}

}  // namespace
}  // namespace steplab::render
