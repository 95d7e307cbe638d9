#include "sim/run/drag_work.hpp"

#include "sim/run/confirmed_steps.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

/// Scenes with drag, weak and, for the kicks, strong.
std::vector<RunDescription> scenes(std::string_view method, Precision precision, double dt) {
    return {run_of("oscillator", method, precision, dt, {{"c", 0.4}}),
            run_of("oscillator", method, precision, dt, {{"c", 30}, {"k", 100}}),
            run_of("chain", method, precision, dt, {{"c", 0.1}}),
            run_of("rope", method, precision, dt, {{"k", 20}, {"c", 0.3}})};
}

struct Measured {
    double energy_error = 0;  ///< largest
    double drag_work = 0;     ///< at the end
};
Measured measured(RunDescription run, double dt, bool counted = true) {
    run.dt = dt;
    Simulation simulation(run);
    EXPECT_TRUE(!counted || simulation.count_drag_work());
    Measured found;
    for (std::uint64_t steps = steps_until(2, dt), i = 0; i < steps; ++i) {
        simulation.advance(1);
        found.energy_error = std::max(found.energy_error, std::abs(simulation.energy_error()));
    }
    found.drag_work = simulation.drag_work().value_or(0);
    return found;
}

bool is_integrated(const MethodCase& c) { return integrates_drag_work(run_of("rope", c.info->id, c.precision, 0.1)); }

class DragWorkOf : public testing::TestWithParam<MethodCase> {};

TEST_P(DragWorkOf, energy_and_work_keep_together_with_the_order_of_the_method) {
    constexpr double dt = 0.005;
    const MethodInfo& info = *GetParam().info;
    for (const RunDescription& run : scenes(info.id, Precision::double_, dt)) {
        SCOPED_TRACE(command_line(run));
        const double change = measured(run, dt, false).energy_error, finer = measured(run, dt / 2, false).energy_error;
        EXPECT_NEAR(finer, change, 0.2 * change);  // what drag takes is none of dt
        const double error = measured(run, dt).energy_error, fine = measured(run, dt / 2).energy_error;
        // of sums of 400 steps; below this rounding rules
        const double rounding = 1e-12 * (1 + change);
        // what the method makes of dt is no exact power of it: half an order is left
        EXPECT_LE(fine, std::max(rounding, error / std::pow(2, info.order_with_drag - 0.5)));
        EXPECT_LE(error, (info.order_with_drag > 1 ? 0.01 : 0.5) * change);
    }
}

TEST_P(DragWorkOf, it_is_that_of_the_motion_whatever_the_precision) {
    const auto [info, precision] = GetParam();
    for (const RunDescription& run : scenes(info->id, precision, 0.01)) {
        RunDescription twice = run;
        twice.precision = Precision::double_;
        const double work = measured(twice, 0.01).drag_work;
        // positions of a metre in float, some hundred roundings
        EXPECT_NEAR(measured(run, 0.01).drag_work, work, 1e-4 * work) << command_line(run);
    }
}

TEST_P(DragWorkOf, counting_changes_no_bit) {
    const auto [info, precision] = GetParam();
    for (const RunDescription& run : scenes(info->id, precision, 0.02)) {
        Simulation plain(run), counted(run);
        ASSERT_TRUE(counted.count_drag_work());
        plain.advance(300);
        for (int i = 0; i < 100; ++i) counted.advance(3);
        EXPECT_EQ(counted.hash(), plain.hash()) << command_line(run);
        EXPECT_EQ(counted.evaluations(), plain.evaluations()) << command_line(run);
    }
}

TEST_P(DragWorkOf, going_back_and_forth_counts_no_step_twice) {
    const auto [info, precision] = GetParam();
    const RunDescription run = run_of("rope", info->id, precision, 0.01, {{"k", 20}});
    Simulation straight(run), confirmed(run);
    ASSERT_TRUE(straight.count_drag_work() && confirmed.count_drag_work());
    ConfirmedSteps stepping(600);
    for (const std::uint64_t step : {7u, 255u, 256u, 300u, 511u, 513u, 600u}) {
        straight.advance(step - straight.step());
        stepping.advance(confirmed, step);
        EXPECT_EQ(confirmed.energy_error(), straight.energy_error()) << step;
        EXPECT_EQ(confirmed.drag_work(), straight.drag_work()) << step;
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, DragWorkOf, testing::ValuesIn(methods_where(is_integrated)), case_name);

TEST(DragWork, of_free_motion_is_what_the_motion_loses) {
    // v = v0 e^(-gamma t): kicks solve it exactly, whatever their length
    for (const double dt : {1e-4, 0.1, 3.0}) {
        Simulation simulation(run_of("chain", "velocity-verlet", Precision::double_, dt,
                                     {{"n", 2}, {"fixed", 1}, {"k", 1e-30}, {"c", 0.7}, {"v0", 2}}));
        ASSERT_TRUE(simulation.count_drag_work());
        simulation.advance(20);
        // 20 steps of some roundings of 2 J
        EXPECT_NEAR(*simulation.drag_work(), 2 * (1 - std::exp(-2 * 0.7 * 20 * dt)), 1e-14) << dt;
    }
}

TEST(DragWork, is_counted_for_splittings_and_explicit_runge_kutta_methods) {
    std::string names;
    for (const Method& method : methods()) {
        if (integrates_drag_work(describe("rope", method.info.id))) names += std::string(method.info.id) + " ";
        EXPECT_FALSE(integrates_drag_work(describe("chain", method.info.id))) << method.info.id;
    }
    EXPECT_EQ(names,
              "euler midpoint rk4 velocity-verlet forest-ruth pefrl mclachlan-atela-5 srkn-11b kahan-li-8 "
              "euler-forward ");
}

TEST(DragWork, is_none_where_it_is_not_counted) {
    Simulation simulation(describe("rope", "rk4"));
    EXPECT_EQ(simulation.drag_work(), std::nullopt);
    Simulation implicit(describe("rope", "tr-bdf2"));
    EXPECT_FALSE(implicit.count_drag_work());
    EXPECT_EQ(implicit.drag_work(), std::nullopt);
}

// Steps behind the last good one were taken, and are no part of the run.
TEST(DragWork, of_a_diverged_run_is_that_of_its_good_steps) {
    const RunDescription run = run_of("rope", "velocity-verlet", Precision::double_, 0.11);
    Simulation diverged(run), good(run);
    ASSERT_TRUE(diverged.count_drag_work() && good.count_drag_work());
    diverged.advance(100'000);
    ASSERT_TRUE(diverged.divergence());
    ASSERT_GT(diverged.step(), 0u);
    good.advance(diverged.step());
    ASSERT_FALSE(good.divergence());
    EXPECT_EQ(*diverged.drag_work(), *good.drag_work());
}

TEST(DragWork, begins_anew_with_the_baseline) {
    Simulation simulation(run_of("rope", "rk4", Precision::double_, 0.01));
    ASSERT_TRUE(simulation.count_drag_work());
    simulation.advance(50);
    EXPECT_GT(*simulation.drag_work(), 0);
    simulation.act(Pull{9, {4, 1, 0}});
    EXPECT_EQ(simulation.drag_work(), 0);
    RunDescription other = simulation.description();
    other.dt = 0.005;
    simulation.advance(10);
    const double before = *simulation.drag_work();
    simulation.change(other);
    EXPECT_EQ(simulation.drag_work(), before);  // the same baseline
    simulation.advance(10);
    EXPECT_GT(*simulation.drag_work(), before);
}

}  // namespace
}  // namespace steplab::test
