#include "sim/run/remedy.hpp"

#include "sim/catalogue.hpp"
#include "sim/run/run_view.hpp"

#include <gtest/gtest.h>

namespace steplab {
namespace {

TEST(remedy, no_method_is_offered_where_none_is_stable) {
    RunDescription description = describe("chain", "euler");
    description.dt = 1000;
    EXPECT_FALSE(stable_method(description));
}

TEST(remedy, the_cheapest_stable_method_is_offered) {
    const auto remedy = stable_method(describe("chain", "midpoint"));
    ASSERT_TRUE(remedy);
    const MethodInfo& info = method(*remedy).info;
    EXPECT_EQ(info.evaluations, 1);
    EXPECT_FALSE(info.curiosity);
}

RunDescription too_large(double dt) {
    RunDescription description = describe("chain", "euler");
    description.dt = dt;
    return description;
}

/// A view that is used again for one run after another, as the window does.
TEST(remedy, a_view_holds_that_of_the_run_it_shows) {
    RunView view;
    observe(Simulation(too_large(0.1)), std::nullopt, view);
    EXPECT_FALSE(view.stable_method);
    for (const double dt : {2.5, 1000.0, 2.5}) {
        Simulation simulation(too_large(dt));
        simulation.advance(100000);
        ASSERT_TRUE(simulation.divergence());
        for (int i = 0; i < 2; ++i) {
            observe(simulation, std::nullopt, view);
            EXPECT_EQ(view.stable_method, stable_method(too_large(dt))) << dt;
        }
    }
    EXPECT_TRUE(view.stable_method);
    observe(Simulation(too_large(0.1)), std::nullopt, view);
    EXPECT_FALSE(view.stable_method);
}

}  // namespace
}  // namespace steplab
