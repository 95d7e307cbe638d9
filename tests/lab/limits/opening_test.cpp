#include "sim/run/opening.hpp"

#include "io/scene_file.hpp"
#include "lab/limits/limits.hpp"
#include "sim/run/linear_limit.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

/// Of the fastest oscillation at the start.
constexpr double fewest_steps_per_period = 10;

/// The models and the shipped scenes as the window opens them.
std::vector<RunDescription> scenes_as_they_open() {
    std::vector<RunDescription> all;
    for (const Model& entry : models()) all.push_back(opening(describe(entry.info.id)));
    for (const std::string& name : shipped_scenes()) all.push_back(describe(find_scene(name)));
    return all;
}

// The frequency is that of the scene itself, of pairs too, for which the model knows none.
TEST(Opening, is_stable_and_resolves_the_fastest_oscillation) {
    for (const RunDescription& run : scenes_as_they_open()) {
        if (chooses_its_steps(run)) continue;  // to its tolerance
        const double omega = StabilityLab(run).omega_max();
        const double drag = facts_of(run).drag;
        const auto limit = [&](double frequency) {
            return linear_limit(method(run.method), run.method_parameters, frequency, drag);
        };
        EXPECT_LT(run.dt, 0.5 * std::min(limit(omega), limit(0))) << run.model;
        EXPECT_LT(omega * run.dt, 2 * std::numbers::pi / fewest_steps_per_period) << run.model;
        const auto treated = resolution(run, omega);
        if (omega > 0) {
            EXPECT_TRUE(treated && treated->is_good()) << run.model;
        }
    }
}

// What linear theory does not cover: the bullet hits the cluster at t = 9.5 s.
TEST(Opening, keeps_the_energy_of_the_motion) {
    for (const RunDescription& run : scenes_as_they_open()) {
        if (model_of(run).particles(run.scene) > 1000) continue;  // takes minutes
        Simulation simulation(run);
        double largest = 0;  // kinetic energy, what the energy error is measured against
        for (double t = 0; t < 20; t += 0.1) {
            simulation.advance(std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::lround(0.1 / run.dt))));
            largest = std::max(largest, simulation.diagnostics().kinetic);
        }
        ASSERT_FALSE(simulation.divergence()) << run.model;
        if (simulation.conservation().energy) {
            EXPECT_LT(std::abs(simulation.energy_error()), 0.01 * largest) << run.model;
        }
    }
}

}  // namespace
}  // namespace steplab::test
