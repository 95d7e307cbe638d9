// Boxes whose edges lean.

#include "core/cell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace steplab {
namespace {

const Cell leaning{{Vec3{4, 0, 0}, Vec3{1, 2, 0}, Vec3{-1, 0.5, 3}}, {1, 2, 3}, {true, true, true}};

double distance(Vec3 a, Vec3 b) { return length(a - b); }

TEST(Cell, has_its_corners_at_the_ends_of_its_edges) {
    const auto corners = leaning.corners();
    EXPECT_EQ(corners[0], (Vec3{1, 2, 3}));
    EXPECT_EQ(corners[3], (Vec3{6, 4, 3}));
    EXPECT_EQ(corners[7], (Vec3{5, 4.5, 6}));
    EXPECT_EQ(leaning.volume(), 24);
}

TEST(Cell, shows_the_image_that_is_inside) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(0.01, 0.99);
    std::uniform_int_distribution<int> boxes(-5, 5);
    const auto& [a, b, c] = leaning.edges;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 inside = leaning.corner + part(random) * a + part(random) * b + part(random) * c;
        const Vec3 image = inside + boxes(random) * a + boxes(random) * b + boxes(random) * c;
        EXPECT_LT(distance(leaning.seen(image), inside), 1e-13);  // some roundings of lengths up to 50
    }
}

TEST(Cell, does_not_repeat_along_an_edge_that_is_not_periodic) {
    Cell open = leaning;
    open.periodic[1] = false;
    const Vec3 outside = open.corner + 0.5 * open.edges[0] + 2.5 * open.edges[1];
    EXPECT_LT(distance(open.seen(outside), outside), 1e-14);
    EXPECT_GT(distance(leaning.seen(outside), outside), 1);
}

TEST(Cell, has_a_nearest_image_along_each_edge) {
    const Vec3 way{0.25, 0.125, 0.5};
    EXPECT_EQ(leaning.through(way), Vec3{});
    const Vec3 edges = 2.0 * leaning.edges[0] - leaning.edges[2];
    EXPECT_LT(distance(leaning.through(way + edges), edges), 1e-14);
}

TEST(Cell, that_is_flat_is_none) {
    EXPECT_TRUE(leaning.is_whole());
    EXPECT_FALSE((Cell{{Vec3{1, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 0, 1}}}.is_whole()));
    EXPECT_FALSE((Cell{{Vec3{1, 0, 0}, Vec3{0, std::nan(""), 0}, Vec3{0, 0, 1}}}.is_whole()));
}

}  // namespace
}  // namespace steplab
