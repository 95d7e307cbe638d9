#include "core/precision.hpp"

#include "core/vec3.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace steplab {
namespace {

// g++ 12 drops such roundings when it vectorises several in a row: the form a frame is made in.
TEST(Precision, rounding_survives_the_optimiser) {
    std::vector<Vec3> rounded;
    for (int i = 1; i < 20; ++i) {
        const double x = i + 1e-12;
        rounded.push_back({rounded_to(Precision::float_, x), rounded_to(Precision::float_, 2 * x),
                           rounded_to(Precision::float_, 3 * x)});
    }
    for (int i = 1; i < 20; ++i) EXPECT_EQ(rounded[static_cast<std::size_t>(i) - 1], (Vec3{1.0 * i, 2.0 * i, 3.0 * i}));
}

TEST(Precision, of_double_changes_nothing) {
    EXPECT_EQ(rounded_to(Precision::double_, 0.1), 0.1);
    EXPECT_EQ(rounded_to(Precision::float_, 0.1), static_cast<double>(0.1f));
    EXPECT_TRUE(std::isinf(rounded_to(Precision::float_, 1e300)));
}

}  // namespace
}  // namespace steplab
