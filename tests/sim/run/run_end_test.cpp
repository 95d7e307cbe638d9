#include "sim/ensemble/ensemble.hpp"
#include "sim/run/confirmed_steps.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

namespace steplab::test {
namespace {

/// A run that is to end at this time.
Simulation ending_at(const RunDescription& run, double until) {
    Simulation simulation(run);
    simulation.end_at(run_end(run, until));
    return simulation;
}

class RunEndOf : public testing::TestWithParam<MethodCase> {};

/// 1, which 0.3 does not divide, also in one step of it.
constexpr double ends[] = {1, 0.2};

TEST_P(RunEndOf, methods_of_own_steps_end_at_the_time_asked_for) {
    const auto [info, precision] = GetParam();
    for (const double until : ends) {
        const RunDescription run = run_of("oscillator", info->id, precision, 0.3);
        const RunEnd end = run_end(run, until);
        EXPECT_EQ(end.step, steps_until(until, 0.3));
        Simulation simulation = ending_at(run, until);
        ConfirmedSteps stepping(end.step);
        for (std::uint64_t step = 1; step <= end.step; ++step) stepping.advance(simulation, step);
        EXPECT_EQ(simulation.step(), end.step);
        EXPECT_EQ(simulation.time(), until);
        EXPECT_EQ(simulation.description(), run);
        // the error at the time it claims, not that of another: 0.2 s away it is 0.2 m. The tolerance is 1e-9
        const double allowed = precision == Precision::float_ ? 1e-5 : 1e-7;
        EXPECT_LT(*simulation.diagnostics().error, allowed);
        EXPECT_NEAR(simulation.state().displacement.at(1).x, std::sin(until), allowed);
    }
}

TEST_P(RunEndOf, rows_before_the_last_are_those_of_equal_steps) {
    const auto [info, precision] = GetParam();
    const RunDescription run = run_of("chain", info->id, precision, 0.3);
    const RunEnd end = run_end(run, 2.2);
    Simulation shortened = ending_at(run, 2.2), whole(run);
    shortened.advance(end.step - 1);
    whole.advance(end.step - 1);
    EXPECT_EQ(shortened.hash(), whole.hash());
    shortened.advance(1);
    whole.advance(1);
    EXPECT_NE(shortened.hash(), whole.hash());
}

TEST_P(RunEndOf, runs_of_an_ensemble_end_there_too) {
    const auto [info, precision] = GetParam();
    const RunDescription run = run_of("chain", info->id, precision, 0.3);
    Simulation simulation = ending_at(run, 1);
    simulation.advance(4);
    const EnsembleRun one{run, run_end(run, 1)};
    for (const EnsembleResult& result : run_ensemble(std::vector(3, one), 1)) {
        EXPECT_EQ(result.result.hash, simulation.hash());
        EXPECT_EQ(result.result.time, 1);
        EXPECT_EQ(result.result.dt, simulation.dt());
    }
}

TEST_P(RunEndOf, a_state_of_before_is_returned_to_from_behind) {
    const auto [info, precision] = GetParam();
    const RunDescription run = run_of("chain", info->id, precision, 0.3);
    Simulation simulation = ending_at(run, 1);
    simulation.advance(2);
    const auto saved = simulation.save();
    simulation.advance(2);
    const std::string hash = simulation.hash();
    simulation.restore(saved);
    EXPECT_EQ(simulation.time(), 2 * simulation.dt());
    simulation.advance(2);
    EXPECT_EQ(simulation.hash(), hash);
    EXPECT_EQ(simulation.time(), 1);
}

INSTANTIATE_TEST_SUITE_P(Methods, RunEndOf, testing::ValuesIn(methods_where([](const MethodCase& c) {
                             return chooses_its_steps(describe("chain", c.info->id));
                         })),
                         case_name);

TEST(RunEnd, of_fixed_steps_and_where_dt_divides_the_time_has_no_time) {
    for (const Method& method : methods()) {
        for (const Precision precision : precisions) {
            const RunDescription run = run_of("chain", method.info.id, precision, 0.1);
            EXPECT_EQ(run_end(run, 0.3).time, std::nullopt);
            EXPECT_EQ(run_end(run, 0.3).step, 3u);
            EXPECT_EQ(run_end(run, 0.35).time.has_value(), chooses_its_steps(run));
            EXPECT_EQ(run_end(run, 0.35).step, 4u);
            EXPECT_EQ(run_end(run, 0).step, 0u);
        }
    }
}

}  // namespace
}  // namespace steplab::test
