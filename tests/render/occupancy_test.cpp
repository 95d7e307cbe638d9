#include "render/occupancy.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace steplab::render {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();

TEST(Occupancy, is_of_the_cells_under_a_disc) {
    Occupancy occupancy({800, 600});
    occupancy.mark({100, 100}, 50);
    EXPECT_EQ(occupancy.taken({90, 90}, {110, 110}), 1);
    EXPECT_EQ(occupancy.taken({400, 400}, {440, 420}), 0);
}

// What a camera makes of positions may be anything; nothing outside the cells is touched (found by the sanitizers).
TEST(Occupancy, takes_any_numbers) {
    Occupancy occupancy({64, 48});
    const double numbers[] = {none, infinite, -infinite, 1e300, -1e300, 1e10, -1e10, 0, 5e-324};
    for (const double x : numbers)
        for (const double y : numbers)
            for (const double radius : numbers) {
                occupancy.mark({x, y}, radius);
                const double taken = occupancy.taken({x, y}, {y, x});
                EXPECT_TRUE(taken >= 0 && taken <= 1) << x << ' ' << y << ' ' << taken;
            }
}

TEST(Occupancy, of_a_disc_that_is_nowhere_is_none) {
    Occupancy occupancy({64, 48});
    occupancy.mark({none, 10}, 20);
    occupancy.mark({10, 10}, none);
    occupancy.mark({infinite, 10}, 20);
    EXPECT_EQ(occupancy.taken({0, 0}, {64, 48}), 0);
    occupancy.mark({32, 24}, infinite);
    EXPECT_EQ(occupancy.taken({0, 0}, {64, 48}), 1) << "a disc as large as the picture";
}

}  // namespace
}  // namespace steplab::render
