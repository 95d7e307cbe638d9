#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

/// dt and drag of runs; fixed steps within their limits of stability.
std::vector<std::pair<double, double>> settings(const MethodInfo& info) {
    if (!info.adaptive) return {{0.1, 0.3}, {0.1, 1}};
    return {{0.1, 0.3}, {0.1, 1}, {0.1, 20}, {2, 0.3}, {2, 1}, {2, 20}, {50, 0.3}, {50, 1}, {50, 20}};
}

class RestOf : public testing::TestWithParam<MethodCase> {};

// Motion below the smallest float: steps grow until nothing but their own bounds limits them.
TEST_P(RestOf, motion_that_drag_has_ended_does_not_come_back) {
    const auto [info, precision] = GetParam();
    for (const auto& [dt, c] : settings(*info)) {
        const RunDescription run = run_of("oscillator", info->id, precision, dt, {{"c", c}});
        SCOPED_TRACE(command_line(run));
        Simulation simulation(run);
        simulation.advance(steps_until(dt < 1 ? 300 : 3000, dt));
        ASSERT_FALSE(simulation.divergence().has_value());
        // errors of some last steps: each of 1e-9, in float of two roundings
        EXPECT_LT(length(simulation.state().displacement.at(1)), precision == Precision::float_ ? 1e-5 : 1e-6);
    }
}

TEST_P(RestOf, it_is_the_same_in_every_instruction_set) {
    const auto [info, precision] = GetParam();
    RunDescription run = run_of("oscillator", info->id, precision, 0.1, {{"c", 1}});
    if (run.method_parameters.contains("tolerance")) run.method_parameters.set("tolerance", 1e-6);
    std::string hash;
    for (const Instructions set : instructions_here()) {
        Simulation simulation(run, {.instructions = set});
        simulation.advance(2500);
        EXPECT_FALSE(simulation.divergence().has_value()) << id(set);
        if (hash.empty()) hash = simulation.hash();
        EXPECT_EQ(simulation.hash(), hash) << id(set);
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, RestOf, testing::ValuesIn(methods_where([](const MethodCase& c) {
                             return c.info->linear_limit > 0 && !c.info->curiosity;
                         })),
                         case_name);

}  // namespace
}  // namespace steplab::test
