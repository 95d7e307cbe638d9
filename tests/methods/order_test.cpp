#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace steplab::test {
namespace {

/// A nonlinear scene in which everything moves: a soft rope falling from the level, with drag or without.
RunDescription falling_rope(const MethodCase& c, double dt, double drag) {
    RunDescription description = run_of("rope", c.id(), c.precision, dt, {{"n", 6}, {"k", 20}, {"c", drag}});
    if (description.method_parameters.contains("substeps")) description.method_parameters.set("substeps", 2);
    return description;
}

/// Where the run is after one second, and a fine run of rk4 in double to compare with: its own error is below 1e-11,
/// a hundredth of the smallest error used.
constexpr double duration = 1;

Frame reference(double drag) {
    static const MethodCase rk4{&method("rk4").info, Precision::double_};
    return frame_after(falling_rope(rk4, 1.0 / 4096, drag), 4096);
}

double error(const MethodCase& c, std::uint64_t steps, double drag, const Frame& reference) {
    return distance(frame_after(falling_rope(c, duration / static_cast<double>(steps), drag), steps), reference);
}

/// The order that halving dt shows: the slope of log error against log dt. Rounding must stay far below the error.
double slope(const MethodCase& c, double drag, std::uint64_t steps) {
    const Frame right = reference(drag);
    return std::log2(error(c, steps, drag, right) / error(c, 2 * steps, drag, right));
}

class Order : public testing::TestWithParam<MethodCase> {};

/// Steps so fine that the next order's term is below a tenth of the error, coarse enough to stand above rounding.
std::uint64_t fine_steps(const MethodCase& c) { return c.info->order == 4 ? 256 : 1024; }

TEST_P(Order, is_the_declared_one_on_both_sides) {
    MethodCase in_double = GetParam();
    in_double.precision = Precision::double_;
    EXPECT_NEAR(slope(in_double, 0, fine_steps(in_double)), GetParam().info->order, 0.1);
    EXPECT_NEAR(slope(in_double, 0.3, fine_steps(in_double)), GetParam().info->order_with_drag, 0.1);
}

// Float has a slope where its rounding, some 1e-5 here (accelerations of 10 and positions of 3 over 256 steps), stays
// far below the error; elsewhere it must be equal to double within that rounding.
TEST_P(Order, of_float_is_that_of_double_within_rounding) {
    MethodCase in_float = GetParam(), in_double = GetParam();
    in_float.precision = Precision::float_;
    in_double.precision = Precision::double_;
    constexpr double rounding = 3e-5;
    for (const std::uint64_t steps : {64u, 128u, 256u}) {
        const double dt = duration / static_cast<double>(steps);
        const Frame a = frame_after(falling_rope(in_float, dt, 0.3), steps),
                    b = frame_after(falling_rope(in_double, dt, 0.3), steps);
        EXPECT_LT(distance(a, b), rounding) << steps;
    }
    const Frame right = reference(0);
    if (error(in_double, 256, 0, right) > 50 * rounding) {
        EXPECT_NEAR(std::log2(error(in_float, 128, 0, right) / error(in_float, 256, 0, right)), GetParam().info->order,
                    0.15);
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Order, testing::ValuesIn(working_methods()), case_name);

// The partner that must fail.
TEST(OrderOfAWrongRun, is_not_the_declared_one) {
    const MethodCase rk4{&method("rk4").info, Precision::double_};
    const Frame right = reference(0);
    // every step 0.1 per mille too long: an error that halving dt does not reduce
    const auto wrong = [&](std::uint64_t steps) {
        return distance(frame_after(falling_rope(rk4, 1.0001 / static_cast<double>(steps), 0), steps), right);
    };
    EXPECT_LT(std::log2(wrong(256) / wrong(512)), 0.1);
}

}  // namespace
}  // namespace steplab::test
