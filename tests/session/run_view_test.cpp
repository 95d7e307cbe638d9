#include "session/run_view.hpp"

#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace steplab::test {
namespace {

RunDescription too_large(double dt) { return run_of("chain", "euler", Precision::double_, dt); }

/// A view that is used again for one run after another, as the window does.
TEST(RunView, has_the_remedies_of_the_run_it_shows) {
    RunView view;
    observe(Simulation(too_large(0.1)), std::nullopt, view);
    EXPECT_FALSE(view.remedies.method);
    for (const double dt : {2.5, 1000.0, 2.5}) {
        Simulation simulation(too_large(dt));
        simulation.advance(100000);
        ASSERT_TRUE(simulation.divergence());
        for (int i = 0; i < 2; ++i) {
            observe(simulation, std::nullopt, view);
            EXPECT_EQ(view.remedies.method, simulation.remedies().method) << dt;
        }
    }
    EXPECT_TRUE(view.remedies.method);
    observe(Simulation(too_large(0.1)), std::nullopt, view);
    EXPECT_FALSE(view.remedies.method);
    EXPECT_FALSE(view.remedies.dt);
}

}  // namespace
}  // namespace steplab::test
