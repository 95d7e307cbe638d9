#include "core/clamped.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace steplab {
namespace {

TEST(clamped_floor, is_the_whole_number_below_within_its_bounds) {
    EXPECT_EQ(clamped_floor(2.9, 0, 5), 2);
    EXPECT_EQ(clamped_floor(-0.1, -3, 5), -1);
    EXPECT_EQ(clamped_floor(5.0, 0, 5), 5);
    EXPECT_EQ(clamped_floor(7, 0, 5), 5);
    EXPECT_EQ(clamped_floor(-7, 0, 5), 0);
}

TEST(clamped_floor, has_a_value_for_every_double) {
    using Limits = std::numeric_limits<double>;
    for (const double x : {Limits::quiet_NaN(), -Limits::infinity(), -1e300}) EXPECT_EQ(clamped_floor(x, 1, 9), 1) << x;
    for (const double x : {Limits::infinity(), 1e300, 1e10}) EXPECT_EQ(clamped_floor(x, 1, 9), 9) << x;
}

}  // namespace
}  // namespace steplab
