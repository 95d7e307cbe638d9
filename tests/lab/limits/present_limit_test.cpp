#include "lab/limits/present_limit.hpp"

#include "sim/run/simulation.hpp"
#include "sim/run/starting.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace steplab::test {
namespace {

PresentLimit present(const Simulation& run) {
    return PresentLimits().at(run.description(), run.state(), run.step(), run.time());
}

// A pair bound by V at the distance r vibrates along its line with omega^2 = 2 V''(r) / m.
TEST(PresentLimit, of_a_pair_follows_the_distance) {
    const RunDescription run = run_of("morse", "velocity-verlet", Precision::double_, 0.01,
                                      {{"edge", 1}, {"k", 8}, {"D", 1}, {"r0", 1}, {"m", 2}});
    const double b = std::sqrt(8.0 / 2);
    PresentLimits limits;
    for (const double r : {0.8, 1.0, 1.05}) {
        Simulation simulation(run);
        simulation.act(Pull{1, simulation.frame().positions[0] + Vec3{-r, 0, 0}});
        const double x = b * (r - 1);
        const double curvature = 2 * b * b * (2 * std::exp(-2 * x) - std::exp(-x));
        const PresentLimit found = limits.at(run, simulation.state(), 0, 0);
        const double omega = std::sqrt(2 * curvature / 2);
        EXPECT_NEAR(found.oscillation.omega, omega, 1e-5 * omega) << r;  // half the accuracy asked of omega^2
        ASSERT_TRUE(found.limit);
        EXPECT_NEAR(*found.limit, 2 / omega, 1e-5 * *found.limit) << r;
        EXPECT_NEAR(std::abs(found.oscillation.shape[0].x), 1, 1e-6);
        EXPECT_NEAR(found.oscillation.shape[0].x, -found.oscillation.shape[1].x, 1e-6)
            << "they swing against each other";
        EXPECT_NEAR(found.oscillation.weights[0], 0.5, 1e-6);
    }
}

// Where a scene starts it is the limit at rest, as the closed form has it; a mesh has that of an infinite one.
TEST(PresentLimit, at_the_start_is_that_at_rest) {
    for (const MethodCase& c : methods_where(has_equal_steps)) {
        for (const char* const model : {"oscillator", "chain", "rope"}) {
            const Simulation run(run_of(model, c.id(), c.precision, 0.01));
            const PresentLimit found = present(run);
            ASSERT_TRUE(found.limit && run.limit()) << c << model;
            EXPECT_NEAR(found.oscillation.omega, run.limit()->omega_max, 2e-5 * run.limit()->omega_max) << c << model;
            if (std::isinf(*found.limit) || *found.limit == 0) {
                EXPECT_EQ(*found.limit, run.limit()->limit) << c << model;
            } else {
                EXPECT_NEAR(*found.limit, run.limit()->limit, 1e-4 * run.limit()->limit) << c << model;
            }
            EXPECT_EQ(found.resolution.has_value(), run.resolution().has_value()) << c << model;
        }
    }
}

// A spring of rest length 0 has one frequency in all directions: the oscillation is that in which the particle moves.
TEST(PresentLimit, of_oscillations_of_one_frequency_is_that_of_the_motion) {
    Simulation run(run_of("oscillator", "rk4", Precision::double_, 0.1));
    run.act(Kick{1, {3, 4, 0}});
    const Vec3 v = run.state().velocity.at(1), u = present(run).oscillation.shape[1];
    EXPECT_GT(std::abs(dot(u, v)) / (length(u) * length(v)), 0.999);  // but for a hundredth of anything
}

TEST(PresentLimit, is_of_the_moment) {
    Simulation run(run_of("morse", "velocity-verlet", Precision::double_, 0.02));
    const double before = present(run).oscillation.omega;
    run.advance(500);  // the bullet is among the others
    const PresentLimit found = present(run);
    EXPECT_EQ(found.step, 500u);
    EXPECT_EQ(found.time, run.time());
    EXPECT_GT(std::abs(found.oscillation.omega / before - 1), 0.01);
    EXPECT_NEAR(std::accumulate(found.oscillation.weights.begin(), found.oscillation.weights.end(), 0.0), 1, 1e-9);
}

TEST(PresentLimit, is_none_of_a_method_that_chooses_its_steps) {
    const PresentLimit found = present(Simulation(run_of("chain", "dopri5", Precision::double_, 0.1)));
    EXPECT_FALSE(found.limit);
    EXPECT_GT(found.oscillation.omega, 1);
}

TEST(PresentLimit, where_nothing_is_driven_back_is_none) {
    const PresentLimit found = present(Simulation(run_of("free", "rk4", Precision::double_, 0.1)));
    EXPECT_EQ(found.oscillation.omega, 0);
    EXPECT_TRUE(found.oscillation.shape.empty());
    ASSERT_TRUE(found.limit);
    EXPECT_TRUE(std::isinf(*found.limit));
}

TEST(PresentLimits, know_a_scene_by_its_parameters) {
    PresentLimits limits;
    const auto omega = [&](double k) {
        const RunDescription run = run_of("oscillator", "rk4", Precision::double_, 0.1, {{"k", k}});
        return limits.oscillation(run, plan_of(run).start.state()).omega;
    };
    EXPECT_NEAR(omega(4), 2, 1e-4);
    EXPECT_NEAR(omega(9), 3, 1e-4);
}

}  // namespace
}  // namespace steplab::test
