#include "sim/run/opening.hpp"

#include "lab/limits/limits.hpp"
#include "sim/run/linear_limit.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steplab::test {
namespace {

/// Of the fastest oscillation at the start.
constexpr double fewest_steps_per_period = 10;

// The frequency is that of the scene itself, of pairs too, for which the model knows none.
TEST(Opening, is_stable_and_resolves_the_fastest_oscillation) {
    for (const Model& entry : models()) {
        const RunDescription run = opening(describe(entry.info.id));
        const double omega = StabilityLab(run).omega_max();
        const double drag = entry.plan(run.scene).drag;
        const auto limit = [&](double frequency) {
            return linear_limit(method(run.method), run.method_parameters, frequency, drag);
        };
        EXPECT_LT(run.dt, 0.5 * std::min(limit(omega), limit(0))) << entry.info.id;
        EXPECT_LT(omega * run.dt, 2 * std::numbers::pi / fewest_steps_per_period) << entry.info.id;
        const auto treated = resolution(run, omega);
        if (omega > 0) {
            EXPECT_TRUE(treated && treated->is_good()) << entry.info.id;
        }
    }
}

// What linear theory does not cover: the bullet hits the cluster at t = 9.5 s.
TEST(Opening, keeps_the_energy_of_the_motion) {
    for (const Model& entry : models()) {
        const RunDescription run = opening(describe(entry.info.id));
        Simulation simulation(run);
        double largest = 0;  // kinetic energy, what the energy error is measured against
        for (double t = 0; t < 20; t += 0.1) {
            simulation.advance(static_cast<std::uint64_t>(std::lround(0.1 / run.dt)));
            largest = std::max(largest, simulation.diagnostics().kinetic);
        }
        ASSERT_FALSE(simulation.divergence()) << entry.info.id;
        if (simulation.conservation().energy) {
            EXPECT_LT(std::abs(simulation.energy_error()), 0.01 * largest) << entry.info.id;
        }
    }
}

}  // namespace
}  // namespace steplab::test
