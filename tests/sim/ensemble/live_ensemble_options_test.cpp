#include "sim/ensemble/live_ensemble_options.hpp"

#include "sim/run/run_description.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace steplab {
namespace {

TEST(LiveEnsembleOptions, differs_in_the_start_first_and_within_the_range) {
    const RunDescription chain = describe("chain", "euler");
    EXPECT_EQ(perturbable(chain).front(), "v0");
    EXPECT_EQ(perturbable(chain).back(), "dt");
    for (const std::string_view name : perturbable(chain)) EXPECT_NE(name, "c") << "no drag: nothing to differ in";
    const ParameterRange speed = range_of({.runs = 2, .spread = "", .width = 0.25}, chain);
    EXPECT_EQ(speed.name, "v0");
    EXPECT_EQ(speed.from, 0.75 * chain.scene["v0"]);
    EXPECT_EQ(speed.to, 1.25 * chain.scene["v0"]);
    const ParameterRange step = range_of({.runs = 2, .spread = "dt", .width = 0.5}, chain);
    EXPECT_EQ(step.from, 0.5 * chain.dt);
    EXPECT_EQ(step.to, 1.5 * chain.dt);
    EXPECT_EQ(range_of({.runs = 2, .spread = "no such thing"}, chain).name, "v0");
}

}  // namespace
}  // namespace steplab
