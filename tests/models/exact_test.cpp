#include "models/chain_modes.hpp"
#include "models/forces/linear_response.hpp"
#include "models/forces/morse_pair.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::test {
namespace {

TEST(KickResponse, solves_its_equation_at_any_damping) {
    // central differences with h = 1e-4 of functions of order 1: truncation 1e-8, rounding 1e-16 / h^2 = 1e-8
    constexpr double h = 1e-4, tolerance = 1e-6;
    for (const double omega2 : {0.0, 0.3, 1.0, 4.0}) {
        for (const double gamma : {0.0, 0.1, 1.0, 2.0, 4.0, 30.0}) {
            for (const double t : {0.5, 1.0, 7.0}) {
                const double before = kick_response(omega2, gamma, t - h), now = kick_response(omega2, gamma, t);
                const double after = kick_response(omega2, gamma, t + h);
                const double second = (after - 2 * now + before) / (h * h), first = (after - before) / (2 * h);
                EXPECT_NEAR(second + gamma * first + omega2 * now, 0, tolerance) << omega2 << " " << gamma << " " << t;
            }
            EXPECT_EQ(kick_response(omega2, gamma, 0), 0);
            EXPECT_NEAR(kick_response(omega2, gamma, 1e-7) / 1e-7, 1, 1e-5);  // g'(0) = 1, next term gamma t / 2
        }
    }
}

TEST(KickResponse, does_not_overflow_when_strongly_damped) {
    EXPECT_NEAR(kick_response(1, 1e4, 1e3), std::exp(-0.1) / 1e4,
                1e-9);  // slow decay at omega^2 / gamma, to order gamma^-3
}

TEST(ChainModes, have_the_published_highest_frequency) {
    EXPECT_NEAR((ChainModes{.count = 10}.highest_frequency()), 1.97272261, 5e-9);  // digits as published
}

TEST(ChainModes, add_up_to_the_kick) {
    // u' at t = 0 is v0 at the last particle and 0 elsewhere: the modes are complete; h as step of the difference
    for (const bool fixed : {true, false}) {
        const auto solution = chain_solution({.count = 10, .first_fixed = fixed}, 2);
        for (std::size_t i = 0; i < 10; ++i) {
            EXPECT_NEAR(solution->displacement(i, 1e-6).x / 1e-6, i == 9 ? 2 : 0, 1e-9) << i;
            EXPECT_EQ(solution->displacement(i, 0).x, 0);
        }
    }
}

TEST(ChainModes, agree_with_the_published_position) {
    const auto solution = chain_solution({.count = 10}, 1);
    EXPECT_NEAR(27 + solution->displacement(9, 68.1).x, 25.78620,
                2e-4);  // 25.78620 is the same time in float
}

TEST(ExactSolution, of_all_particles_is_that_of_each) {
    const auto exact_of = [](const Model& it) { return it.exact(ParameterValues(it.info.parameters)); };
    for (const Model* const model : models_where(exact_of)) {
        const auto exact = exact_of(*model);
        std::vector<Vec3> all(static_cast<std::size_t>(model->particles(ParameterValues(model->info.parameters))));
        ASSERT_FALSE(all.empty());
        exact->displacements(3.7, all);
        for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i], exact->displacement(i, 3.7)) << model->info.id;
    }
}

TEST(ExactSolution, is_not_claimed_where_neighbours_may_pass) {
    const auto exact = [](Settings settings) {
        return model("chain").exact(run_of("chain", "rk4", Precision::double_, 0.1, settings).scene) != nullptr;
    };
    EXPECT_TRUE(exact({}));
    EXPECT_TRUE(exact({{"v0", -2}, {"fixed", 0}}));
    EXPECT_FALSE(exact({{"v0", 2.01}}));
    EXPECT_FALSE(exact({{"k", 0.9}}));
    EXPECT_TRUE(exact({{"L", 0}, {"v0", 100}}));
    EXPECT_FALSE(exact({{"n", 5000}}));
}

TEST(OmegaMax, is_known_for_springs) {
    const auto omega = [](std::string_view id, Settings settings = {}) {
        return model(id).omega_max(run_of(id, "rk4", Precision::double_, 0.1, settings).scene);
    };
    EXPECT_EQ(omega("free"), 0);
    EXPECT_EQ(omega("oscillator", {{"k", 9}, {"m", 4}}), 1.5);
    EXPECT_NEAR(*omega("chain"), 1.97272261, 5e-9);
    EXPECT_NEAR(*omega("rope"), 1.97272261 * std::sqrt(200), 1e-7);
    EXPECT_NEAR(*omega("mesh"), std::sqrt(8), 1e-15);
    EXPECT_FALSE(omega("morse").has_value());
}

TEST(Morse, has_its_minimum_at_r0) {
    const MorseConstants<double> morse{2, 0.7, 2, 2 * 0.7 * 2};
    EXPECT_EQ(morse_energy(morse, 2.0), -2);
    EXPECT_EQ(morse_pull(morse, Vector<double>{2, 0, 0}).x, 0);
    EXPECT_LT(morse_pull(morse, Vector<double>{3, 0, 0}).x, 0);  // attracted
    EXPECT_GT(morse_pull(morse, Vector<double>{1, 0, 0}).x, 0);  // repelled
}

}  // namespace
}  // namespace steplab::test
