#include "sim/run/resolution.hpp"

#include "sim/run/start_frequency.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steplab::test {
namespace {

RunDescription oscillator(std::string_view method, double steps_per_period) {
    return run_of("oscillator", method, Precision::double_, 2 * std::numbers::pi / steps_per_period);
}

class ResolutionOf : public testing::TestWithParam<MethodCase> {};

// The oscillator itself, a whole number of steps later: (x, v) is (0, 1) again but for the error. The ellipse on which
// symplectic methods move is no circle: that and what is of second order in the error is within a factor of 2.
TEST_P(ResolutionOf, predicts_the_error_of_one_period) {
    for (const int steps : {8, 16, 32}) {
        const RunDescription run = oscillator(GetParam().id(), steps);
        const auto predicted = resolution(run, 1);
        ASSERT_TRUE(predicted);
        EXPECT_NEAR(predicted->steps_per_period, steps, 1e-12 * steps);
        Simulation simulation(run);
        simulation.advance(static_cast<std::uint64_t>(steps));
        const Vec3 x = simulation.state().displacement.at(1), v = simulation.state().velocity.at(1);
        const double error = std::hypot(x.x, v.x - 1);
        if (predicted->error > 0.3 || predicted->error < 1e-11) continue;  // of no order, or rounding
        EXPECT_GT(error, predicted->error / 2) << steps;
        EXPECT_LT(error, 2 * predicted->error) << steps;
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, ResolutionOf, testing::ValuesIn(working_methods_where([](const MethodCase& c) {
                             const RunDescription run = describe("oscillator", c.id());
                             return c.precision == Precision::double_ && !chooses_its_steps(run);
                         })),
                         case_name);

TEST(Resolution, has_the_damping_of_rk4) {
    const double z = 2.1;
    const auto treated = resolution(run_of("oscillator", "rk4", Precision::double_, z), 1);
    // |1 + iz - z²/2 - iz³/6 + z⁴/24|
    const double size = std::hypot(1 - z * z / 2 + z * z * z * z / 24, z - z * z * z / 6);
    EXPECT_NEAR(size, 0.68, 0.005);
    EXPECT_NEAR(treated->amplification, std::pow(size, 2 * std::numbers::pi / z), 1e-12);
    EXPECT_FALSE(treated->keeps_motion());
}

TEST(Resolution, is_good_of_enough_steps_and_no_longer_near_the_limit) {
    for (const MethodCase& c : working_methods_where(has_equal_steps)) {
        const double limit = linear_limit(*c.info, ParameterValues(c.info->parameters));
        if (c.precision == Precision::float_ || limit == 0) continue;
        EXPECT_TRUE(resolution(oscillator(c.id(), 25), 1)->is_good()) << c;
        EXPECT_FALSE(resolution(run_of("oscillator", c.id(), Precision::double_, 0.98 * limit), 1)->is_good()) << c;
    }
}

TEST(Resolution, is_bad_of_stable_methods_that_see_too_little) {
    for (const std::string_view id : {"implicit-midpoint", "tr-bdf2", "stoermer"})
        EXPECT_FALSE(resolution(oscillator(id, 3), 1)->is_good()) << id;
}

TEST(Resolution, is_not_judged_where_nothing_oscillates_or_steps_are_chosen) {
    EXPECT_FALSE(resolution(describe("free", "rk4"), 0));
    EXPECT_FALSE(resolution(describe("chain", "taylor"), 2));
    EXPECT_FALSE(resolution(describe("chain", "verlet-2008"), 2));
}

double frequency_of(std::string_view id, Settings settings = {}) {
    return start_frequency(model(id).plan(run_of(id, "rk4", Precision::double_, 0.1, settings).scene));
}

// A particle kicked along its springs: the force constants of those on k / m; 4 eps for sums and roots.
TEST(StartFrequency, is_that_of_the_kicked_particle) {
    EXPECT_NEAR(frequency_of("oscillator", {{"k", 9}, {"m", 4}}), 1.5, 1e-15);
    EXPECT_NEAR(frequency_of("chain"), 1, 1e-15) << "one spring at the end";
    EXPECT_NEAR(frequency_of("mesh", {{"L", 0}, {"k", 2}}), 4, 4e-15) << "eight springs of rest length 0";
}

TEST(StartFrequency, is_zero_where_nothing_drives_the_motion_back) {
    EXPECT_EQ(frequency_of("free"), 0);
    EXPECT_EQ(frequency_of("mesh"), 0) << "across springs at their rest length";
    EXPECT_EQ(frequency_of("rope"), 0) << "the same, falling from rest";
    EXPECT_EQ(frequency_of("chain", {{"v0", 0}}), 0) << "nothing moves";
}

TEST(StartFrequency, does_not_depend_on_the_size_of_the_motion) {
    for (const double v0 : {1e-300, 1e-150, 1e150, 1e308})
        EXPECT_DOUBLE_EQ(frequency_of("chain", {{"v0", v0}}), frequency_of("chain")) << v0;
}

TEST(StartFrequency, is_never_above_the_largest) {
    for (const Model& entry : models()) {
        const ParameterValues values(entry.info.parameters);
        EXPECT_LE(start_frequency(entry.plan(values)), entry.omega_max(values).value_or(infinity)) << entry.info.id;
    }
}

}  // namespace
}  // namespace steplab::test
