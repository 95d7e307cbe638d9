#include "methods/collisions.hpp"

#include "core/power.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::test {
namespace {

RunDescription adaptive_run(std::string_view model, std::string_view id, double dt, double tolerance,
                            Settings settings = {}, Precision precision = Precision::double_) {
    RunDescription description = run_of(model, id, precision, dt, settings);
    description.method_parameters.set("tolerance", tolerance);
    return description;
}

constexpr std::string_view ids[] = {"dopri5", "dop853", "rkn-12-10"};

// Two particles of a spring of rest length 1, the second thrown at the held first: from d = 1 it arrives at d = 0 with
// v^2 = v0^2 - 1, having moved as x = v0 sin t, and flies on as if the spring's other side began: d = -sin of what is
// left.
TEST(Collisions, of_a_chain_are_found_located_and_passed) {
    const double v0 = 2, meeting = std::asin(1 / v0), speed = std::sqrt(v0 * v0 - 1);
    for (const std::string_view id : ids) {
        Simulation simulation(adaptive_run("chain", id, 1, 1e-13, {{"n", 2}, {"L", 1}, {"v0", -v0}}));
        simulation.advance(1);
        const auto collisions = simulation.collisions();
        ASSERT_EQ(collisions.count(), 1u) << id;
        EXPECT_NEAR(collisions.kept()[0].time, meeting, 1e-12) << id;
        EXPECT_EQ(collisions.kept()[0].first, 0u);
        EXPECT_EQ(collisions.kept()[0].second, 1u);
        // behind: x'' = -(x + 1), x(0) = 0, x' = -speed
        const double left = 1 - meeting, x = std::cos(left) - 1 - speed * std::sin(left);
        EXPECT_NEAR(simulation.frame().positions[1].x, x, 1e-11) << id;
    }
}

TEST(Collisions, are_none_where_particles_keep_apart) {
    for (const std::string_view id : ids) {
        Simulation simulation(adaptive_run("chain", id, 1, 1e-10));
        simulation.advance(60);
        EXPECT_EQ(simulation.collisions().count(), 0u) << id;
    }
}

// The cube of spacing 0.5: mirror pairs meet head on. The error at t = 2 falls with the tolerance; a method that does
// not look, rk4, is off by 1e-3 there.
TEST(Collisions, of_the_morse_cube_do_not_stall_the_error) {
    const auto end = [](double tolerance) {
        Simulation simulation(adaptive_run("morse", "rkn-12-10", 2, tolerance, {{"spacing", 0.5}, {"v0", 1.5}}));
        simulation.advance(1);
        EXPECT_EQ(simulation.collisions().count(), 2u);
        EXPECT_NEAR(simulation.collisions().kept()[0].time, 0.937855, 1e-5);  // as the finest run has it
        return simulation.frame();
    };
    const Frame right = end(1e-15);
    EXPECT_LT(distance(end(1e-12), right), 1e-10);
    EXPECT_LT(distance(end(1e-8), right), 1e-6);
    const Frame blind =
        frame_after(run_of("morse", "rk4", Precision::double_, 1.0 / 512, {{"spacing", 0.5}, {"v0", 1.5}}), 1024);
    EXPECT_GT(distance(blind, right), 1e-6);
}

// Against libm, which is right within an ulp.
TEST(Power, is_right) {
    for (const double base : {1e-300, 1e-9, 0.3, 0.75, 1.0, 1.4, 7.0, 1e12, 1e300}) {
        EXPECT_NEAR(logarithm(base), std::log(base), 4e-16 * std::max(1.0, std::abs(std::log(base)))) << base;
        EXPECT_NEAR(power(base, 1.0 / 11) / std::pow(base, 1.0 / 11), 1, 1e-13) << base;
    }
    EXPECT_EQ(power(1, 0.3), 1);
    EXPECT_LT(power(0, 0.1), 1e-30);
}

}  // namespace
}  // namespace steplab::test
