#include "sim/catalogue.hpp"
#include "sim/ensemble/live_ensemble_options.hpp"

#include <gtest/gtest.h>

namespace steplab {
namespace {

TEST(NearestLiveEnsemble, has_the_varied_number_and_its_relative_width) {
    RunDescription description = describe("morse");
    description.dt = 0.01;
    description.scene.set("v0", 2);
    // (2.2 - 1.8) / 2 / 2, each number rounded once or twice.
    const LiveEnsembleOptions speed = nearest_live_ensemble(description, 9, {{"v0", 1.8, 2.2}});
    EXPECT_EQ(speed.runs, 9u);
    EXPECT_EQ(speed.spread, "v0");
    EXPECT_NEAR(speed.width, 0.1, 1e-15);
    EXPECT_FALSE(speed.otherwise);
    const LiveEnsembleOptions falling = nearest_live_ensemble(description, 9, {{"v0", 2.2, 1.8}});
    EXPECT_EQ(falling, speed);
    const LiveEnsembleOptions step = nearest_live_ensemble(description, 2, {{"dt", 0.0075, 0.0125}});
    EXPECT_EQ(step.spread, "dt");
    EXPECT_NEAR(step.width, 0.25, 1e-15);
    EXPECT_FALSE(step.otherwise);
    description.scene.set("v0", 1);
    // Both ends are rounded: by up to 1e-16 over a width of 1e-6.
    const LiveEnsembleOptions fine = nearest_live_ensemble(description, 256, {{"v0", 0.999999, 1.000001}});
    EXPECT_NEAR(fine.width, 1e-6, 2e-16);
    EXPECT_FALSE(fine.otherwise);
}

TEST(NearestLiveEnsemble, of_equal_runs_has_no_width) {
    const LiveEnsembleOptions ensemble = nearest_live_ensemble(describe("morse"), 5, {});
    EXPECT_EQ(ensemble.width, 0);
    EXPECT_FALSE(ensemble.otherwise);
}

TEST(NearestLiveEnsemble, that_the_window_does_not_have_is_marked) {
    RunDescription description = describe("chain", "dopri5");
    EXPECT_TRUE(nearest_live_ensemble(description, 5, {{"tolerance", 1e-9, 1e-6}}).otherwise) << "of the method";
    EXPECT_TRUE(nearest_live_ensemble(description, 5, {{"c", 0, 0.1}}).otherwise) << "its own value is 0";
    EXPECT_TRUE(nearest_live_ensemble(description, 5, {{"n", 10, 10}}).otherwise) << "a whole number";
    const double k = description.scene["k"];
    EXPECT_TRUE(nearest_live_ensemble(description, 5, {{"k", k, 1.1 * k}}).otherwise) << "not about its own value";
    EXPECT_TRUE(nearest_live_ensemble(description, 5, {{"k", 0.25 * k, 1.75 * k}}).otherwise) << "too wide";
    const ParameterRange both{"k", 0.75 * k, 1.25 * k};
    EXPECT_FALSE(nearest_live_ensemble(description, 5, {both}).otherwise);
    EXPECT_TRUE(nearest_live_ensemble(description, 5, {both, {"v0", 1, 3}}).otherwise) << "two numbers";
}

}  // namespace
}  // namespace steplab
