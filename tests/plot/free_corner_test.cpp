#include "plot/free_corner.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace steplab::plot {
namespace {

constexpr Box frame{100, 50, 400, 200};
constexpr Box card{0, 0, 120, 40};
constexpr std::array corners{Corner::top_right, Corner::top_left, Corner::bottom_right, Corner::bottom_left};

Box card_at(Corner corner, float above = 0) { return card_in(frame, corner, card.width, card.height, above); }

/// A line across a corner's card, from its left to its right.
std::vector<Point> through(Corner corner) {
    const Box box = card_at(corner);
    return {{box.x - 10, box.y + 20}, {box.right() + 10, box.y + 20}};
}

TEST(FreeCorner, cards_lie_within_the_frame) {
    for (const Corner corner : corners) {
        for (const float above : {0.0F, 16.0F, 1000.0F}) {
            const Box box = card_at(corner, above);
            EXPECT_GE(box.x, frame.x);
            EXPECT_LE(box.right(), frame.right());
            EXPECT_GE(box.y, frame.y);
            EXPECT_LE(box.bottom(), frame.bottom());
        }
    }
    EXPECT_EQ(card_at(Corner::bottom_left, 16).bottom(), frame.bottom() - 16);
}

TEST(FreeCorner, length_of_a_line_within_a_box) {
    const Box box{0, 0, 10, 10};
    EXPECT_FLOAT_EQ(length_within(std::vector<Point>{{-5, 5}, {20, 5}}, box), 10);
    EXPECT_FLOAT_EQ(length_within(std::vector<Point>{{5, -5}, {5, 3}}, box), 3);
    EXPECT_FLOAT_EQ(length_within(std::vector<Point>{{0, 0}, {20, 20}}, box), 10 * std::sqrt(2.0F));
    EXPECT_FLOAT_EQ(length_within(std::vector<Point>{{2, 2}, {4, 2}, {4, 5}}, box), 5);
    EXPECT_EQ(length_within(std::vector<Point>{{-5, 12}, {20, 12}}, box), 0);
    EXPECT_EQ(length_within(std::vector<Point>{{11, -5}, {30, 15}}, box), 0);
    EXPECT_EQ(length_within(std::vector<Point>{{5, 5}}, box), 0);
}

// Against the part of many points of each stretch that lie in the box.
TEST(FreeCorner, length_is_that_of_the_points_inside) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-20, 30);
    const Box box{0, 0, 10, 10};
    for (int i = 0; i < 200; ++i) {
        const Point a{place(random), place(random)}, b{place(random), place(random)};
        constexpr int points = 4000;
        int inside = 0;
        for (int k = 0; k < points; ++k) {
            const float t = (static_cast<float>(k) + 0.5F) / points;
            inside += box.contains(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
        }
        const float length = std::hypot(b.x - a.x, b.y - a.y);
        // a point is missed or counted too much at each end
        EXPECT_NEAR(length_within(std::vector<Point>{a, b}, box), length * static_cast<float>(inside) / points,
                    3 * length / points);
    }
}

TEST(FreeCorner, is_where_the_lines_are_not) {
    for (const Corner clear : corners) {
        std::vector<std::vector<Point>> lines;
        for (const Corner other : corners) {
            if (other != clear) lines.push_back(through(other));
        }
        for (const Corner present : corners) EXPECT_EQ(free_corner(lines, frame, card, 0, present, 30), clear);
    }
}

TEST(FreeCorner, does_not_cover_the_highest_peak) {
    const Box right = card_at(Corner::top_right), left = card_at(Corner::top_left);
    // one stroke up into the card at the right, three through that at the left
    std::vector<std::vector<Point>> lines{{{right.x + 20, 240}, {right.x + 30, right.y + 5}, {right.x + 40, 240}}};
    for (const float x : {20.0F, 40.0F, 60.0F}) lines.push_back({{left.x + x, left.y + 10}, {left.x + x, left.y + 90}});
    for (const float x : {0.0F, 60.0F}) lines.push_back({{left.x + x, 245}, {right.right() - x, 245}});
    EXPECT_EQ(free_corner(lines, frame, card, 0, Corner::top_right, 30), Corner::top_left);
    lines[0].pop_back();  // the end of a line that rises
    EXPECT_EQ(free_corner(lines, frame, card, 0, Corner::top_right, 30), Corner::top_left);
    lines[0][1].y = left.y + 60;  // below the card
    EXPECT_EQ(free_corner(lines, frame, card, 0, Corner::top_right, 30), Corner::top_right);
}

TEST(FreeCorner, peaks_of_an_oscillation_count_as_other_points) {
    const Box right = card_at(Corner::top_right), left = card_at(Corner::top_left);
    for (const float higher : {-1.0F, 0.0F, 1.0F}) {
        const std::vector<std::vector<Point>> lines{
            {{left.x + 40, 120}, {left.x + 60, left.y + 10 - higher}, {left.x + 80, 120}},
            {{right.x + 40, 120}, {right.x + 60, right.y + 10}, {right.x + 80, 120}},
            through(Corner::bottom_left),
            through(Corner::bottom_right)};
        for (const Corner present : {Corner::top_left, Corner::top_right})
            EXPECT_EQ(free_corner(lines, frame, card, 0, present, 20), present) << higher;
    }
}

TEST(FreeCorner, stays_unless_another_is_much_better) {
    const std::vector<std::vector<Point>> everywhere{through(Corner::top_right), through(Corner::top_left),
                                                     through(Corner::bottom_right), through(Corner::bottom_left)};
    for (const Corner present : corners) {
        EXPECT_EQ(free_corner(everywhere, frame, card, 0, present, 30), present);
        EXPECT_EQ(free_corner({}, frame, card, 0, present, 30), present);
    }
    const Box box = card_at(Corner::top_right);
    const std::vector<std::vector<Point>> touched{{{box.x, box.y + 5}, {box.x + 20, box.y + 5}}};
    EXPECT_EQ(free_corner(touched, frame, card, 0, Corner::top_right, 30), Corner::top_right);
    EXPECT_NE(free_corner(touched, frame, card, 0, Corner::top_right, 10), Corner::top_right);
}

/// The corner of a card in each picture of a curve that grows, sampled 20 times a second; of the last `window` seconds,
/// or from the start.
template <class Function>
std::vector<Corner> corners_of(const Function& function, double window = INFINITY) {
    std::vector<Corner> all{Corner::top_right};
    for (int last = 10; last <= 1600; last += 2) {
        const int first = static_cast<int>(std::max(0.0, last - 20 * window));
        std::vector<std::vector<Point>> lines(1);
        for (int i = first; i <= last; ++i)
            lines[0].push_back(
                {frame.x + frame.width * static_cast<float>(i - first) / static_cast<float>(last - first),
                 frame.y + frame.height * static_cast<float>(0.5 - 0.45 * function(i / 20.0))});
        all.push_back(free_corner(lines, frame, card, 0, all.back(), 20));
    }
    return all;
}

/// Numbers of the pictures in which it moves.
std::vector<std::size_t> moves_of(const std::vector<Corner>& corners) {
    std::vector<std::size_t> moves;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        if (corners[i] != corners[i - 1]) moves.push_back(i);
    }
    return moves;
}

TEST(FreeCorner, makes_way_for_a_curve_that_grows_into_it) {
    // 1 s in the middle, then up to the upper edge: it runs into the card at the right, and stays there
    const auto rises = [](double time) { return time < 1 ? 0 : 1 - std::exp(1 - time); };
    EXPECT_LE(moves_of(corners_of(rises, 4)).size(), 2u);
    EXPECT_EQ(corners_of(rises, 4).back(), Corner::bottom_right);
    // 10 pixels of its end, with other corners free
    const Box box = card_at(Corner::top_right);
    std::vector<std::vector<Point>> lines(1);
    for (int i = 0; i <= 40; ++i) lines[0].push_back({box.x - 150 + 4 * static_cast<float>(i), box.y + 10});
    EXPECT_NE(free_corner(lines, frame, card, 0, Corner::top_right, 20), Corner::top_right);
    std::reverse(lines[0].begin(), lines[0].end());  // 10 pixels of its start
    EXPECT_EQ(free_corner(lines, frame, card, 0, Corner::top_right, 20), Corner::top_right);
}

TEST(FreeCorner, does_not_go_to_and_fro_while_curves_oscillate) {
    for (const double frequency : {0.25, 1.0, 7.0}) {
        const auto swings = [&](double time) { return std::sin(frequency * time); };
        for (const double window : {20.0, 60.0, double(INFINITY)}) {
            const std::vector<std::size_t> moves = moves_of(corners_of(swings, window));
            EXPECT_LE(moves.size(), 10u) << "in 80 s: " << frequency << " " << window;
            for (std::size_t i = 1; i < moves.size(); ++i)  // 10 pictures: 1 s of the curve
                EXPECT_GE(moves[i] - moves[i - 1], 10u) << frequency << " " << window << " " << moves[i];
        }
    }
}

}  // namespace
}  // namespace steplab::plot
