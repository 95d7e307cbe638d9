#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::test {
namespace {

/// What rounding alone may add to positions of this size in so many steps: an ulp a step, some of them adding up.
double rounding(Precision precision, double size, std::uint64_t steps) {
    const double epsilon = precision == Precision::float_ ? 1.2e-7 : 2.2e-16;
    return epsilon * size * static_cast<double>(steps);
}

class ExactAnswers : public testing::TestWithParam<MethodCase> {
protected:
    /// Largest distance from the exact solution after `steps` steps.
    double error(std::string_view model, std::uint64_t steps, double dt, Settings settings = {}) const {
        Simulation simulation(run_of(model, GetParam().id(), GetParam().precision, dt, settings));
        simulation.advance(steps);
        EXPECT_EQ(simulation.step(), steps);
        return simulation.diagnostics().error.value();
    }
    const MethodInfo& info() const { return *GetParam().info; }
    /// What truncation may add up to in time t where an error of order p is bounded by t omega^(p+1) dt^p; adaptive
    /// methods keep it to some ten times their tolerance a unit of time.
    double truncation(double t, double dt, double omega = 1) const {
        if (info().adaptive) return 10 * ParameterValues(info().parameters)["tolerance"] * t;
        return t * std::pow(omega, info().order + 1) * std::pow(dt, info().order);
    }
    Precision precision() const { return GetParam().precision; }
};

// Constant acceleration: every method of order 2 and above is exact; euler is off by -0.05 i t dt, at most 0.45 t dt.
TEST_P(ExactAnswers, free_fall) {
    constexpr std::uint64_t steps = 128;
    constexpr double dt = 1.0 / 16, t = dt * steps;
    const double expected = info().order == 1 ? 0.45 * t * dt : 0;
    EXPECT_NEAR(error("free", steps, dt), expected, rounding(precision(), 0.45 * t * t, steps));
}

TEST_P(ExactAnswers, oscillator_with_and_without_drag) {
    constexpr std::uint64_t steps = 256;
    constexpr double dt = 1.0 / 64, t = dt * steps;
    const double bound = truncation(t, dt) + rounding(precision(), 1, steps);
    EXPECT_LT(error("oscillator", steps, dt), bound);
    EXPECT_LT(error("oscillator", steps, dt, {{"c", 0.5}}), bound);
    EXPECT_LT(error("oscillator", steps, dt, {{"c", 4.0}}),
              bound * 64);  // modes decay at up to 3.7: (3.7)^(p+1) at p = 2
}

TEST_P(ExactAnswers, chain_fixed_and_free) {
    constexpr std::uint64_t steps = 256;
    constexpr double dt = 1.0 / 64, t = dt * steps;
    const double bound = 2 * truncation(t, dt, 2);
    EXPECT_LT(error("chain", steps, dt), bound + rounding(precision(), 2, steps));
    EXPECT_LT(error("chain", steps, dt, {{"fixed", 0}}), bound + rounding(precision(), 8, steps));
    EXPECT_LT(error("chain", steps, dt, {{"c", 0.3}}), bound + rounding(precision(), 2, steps));
}

// The partner: the same bounds refuse a run whose stiffness is 5 % off. (rk4's bound in double is the tightest.)
TEST(ExactAnswersOfAWrongScene, are_refused) {
    Simulation simulation(run_of("oscillator", "rk4", Precision::double_, 1.0 / 64, {{"k", 1.05}}));
    simulation.advance(256);
    const double right = std::sin(4.0);
    EXPECT_GT(std::abs(simulation.frame().positions[1].x - right), 1e-3);
}

// Link j is stretched by (n - j) g / k, when drag has damped everything. A run stands still where an increment dt^2 a
// is below half an ulp of a position of 7: at a = 2e-12 in double and 2e-3 in float, which moves the end by a length /
// g.
TEST_P(ExactAnswers, hanging_rope) {
    const double dt = info().order == 4 ? 0.05 : 0.01;
    Simulation simulation(run_of("rope", GetParam().id(), precision(), dt, {{"c", 3}}));
    simulation.advance(20000);
    const Frame frame = simulation.frame();
    // an adaptive method at rest goes on with steps whose errors balance the drag, here some hundred times its
    // tolerance
    const double tolerance = precision() == Precision::float_ ? 2e-3 : info().adaptive ? 1e-7 : 4e-12;
    double y = 0;
    for (std::size_t j = 1; j < 10; ++j) {
        y -= 0.5 + static_cast<double>(10 - j) * 9.81 / 200;
        EXPECT_NEAR(frame.positions[j].y, y, tolerance) << j;
        EXPECT_NEAR(frame.positions[j].x, 0, tolerance) << j;
    }
    EXPECT_NEAR(frame.positions[9].y, -6.70725, tolerance);
}

// The transverse motion of a mesh has no closed form; its symmetry is exact: kicked in the very centre of an odd mesh,
// it stays symmetric to reflections within rounding of sums taken in another order.
TEST_P(ExactAnswers, mesh_keeps_its_symmetry) {
    Simulation simulation(run_of("mesh", GetParam().id(), precision(), 0.05, {{"dim", 7}}));
    simulation.advance(100);
    const Frame frame = simulation.frame();
    const double tolerance = rounding(precision(), 1, 100);
    for (std::size_t i = 0; i < 7; ++i) {
        for (std::size_t j = 0; j < 7; ++j) {
            EXPECT_NEAR(frame.positions[i * 7 + j].y, frame.positions[i * 7 + (6 - j)].y, tolerance);
            EXPECT_NEAR(frame.positions[i * 7 + j].y, frame.positions[j * 7 + i].y, tolerance);
        }
    }
    EXPECT_GT(std::abs(frame.positions[24].y), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, ExactAnswers, testing::ValuesIn(working_methods()), case_name);

struct Pass {
    double v0, speed;
};

// First pass of the bullet: it escapes with the published speeds along x (three digits) at v0 = 2 and 1.5; at v0 = 1 it
// passes, turns near x = 15.5 at t = 30 and is pulled back.
TEST(Morse, bullet_escapes_with_the_published_speed) {
    for (const auto& [v0, speed] : {Pass{2, 2.11}, Pass{1.5, 1.03}}) {
        Simulation simulation(run_of("morse", "rk4", Precision::double_, 0.002, {{"v0", v0}}));
        while (simulation.frame().positions.back().x < 60 && simulation.time() < 100) simulation.advance(100);
        EXPECT_NEAR(simulation.frame().velocities.back().x, speed, 0.006) << v0;
    }
}

TEST(Morse, slow_bullet_is_pulled_back) {
    Simulation simulation(run_of("morse", "rk4", Precision::double_, 0.002));
    while (simulation.frame().positions.back().x < 10) simulation.advance(50);
    while (simulation.frame().velocities.back().x > 0) simulation.advance(50);
    EXPECT_NEAR(simulation.frame().positions.back().x, 15.5, 0.5);  // "near" as published
    EXPECT_NEAR(simulation.time(), 30, 2);
}

}  // namespace
}  // namespace steplab::test
