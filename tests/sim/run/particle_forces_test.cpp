#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace steplab::test {
namespace {

// Force = mass times the change of velocity, drag included: central differences over 2 h are off by h^2 / 6 of the
// second derivative, some 1e-5 of the largest force at omega h = 0.01.
TEST(ParticleForces, of_every_model_change_its_velocities) {
    for (const Model& model : models()) {
        const double h = 0.001;
        RunDescription run = small_run_of(model.info.id, "rk4", Precision::double_, h);
        Simulation simulation(run);
        simulation.advance(300);
        const Frame before = simulation.frame();
        simulation.advance(1);
        std::vector<Vec3> forces;
        simulation.forces(forces);
        simulation.advance(1);
        const Frame after = simulation.frame();
        const Plan plan = model_of(run).plan(run.scene);
        double largest = 0, error = 0;
        ASSERT_EQ(forces.size(), before.velocities.size()) << model.info.id;
        for (std::size_t i = 0; i < forces.size(); ++i) {
            const Vec3 change = (plan.mass / (2 * h)) * (after.velocities[i] - before.velocities[i]);
            largest = std::max(largest, length(forces[i]));
            error = std::max(error, length(change - forces[i]));
        }
        EXPECT_LE(error, 1e-3 * largest) << model.info.id;
        EXPECT_GE(largest, 0);
    }
}

TEST(ParticleForces, follow_a_live_change) {
    RunDescription run = describe("oscillator", "rk4");
    Simulation simulation(run);
    std::vector<Vec3> before, after;
    simulation.advance(5);
    simulation.forces(before);
    ASSERT_GT(length(before.back()), 0);
    run.scene.set("k", 3 * run.scene["k"]);
    ASSERT_EQ(simulation.change(run), Change::continued);
    simulation.forces(after);
    EXPECT_NEAR(after.back().x / before.back().x, 3, 1e-12);
}

}  // namespace
}  // namespace steplab::test
