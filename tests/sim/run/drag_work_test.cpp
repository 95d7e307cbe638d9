#include "sim/run/drag_work.hpp"

#include "sim/run/alterations.hpp"
#include "sim/run/confirmed_steps.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

RunDescription with_alteration(const RunDescription& run, const Alteration& one) {
    return with_alterations(run, {&one, 1});
}

/// Scenes with drag, weak and, for the kicks, strong; the last two of the composed layout, one with particles each of
/// which has a rate of its own.
std::vector<RunDescription> scenes(std::string_view method, Precision precision, double dt) {
    const RunDescription rope = run_of("rope", method, precision, dt, {{"k", 20}, {"c", 0.3}});
    std::vector<RunDescription> all{run_of("oscillator", method, precision, dt, {{"c", 0.4}}),
                                    run_of("oscillator", method, precision, dt, {{"c", 30}, {"k", 100}}),
                                    run_of("chain", method, precision, dt, {{"c", 0.1}}),
                                    rope,
                                    with_alteration(rope, {.particle = 3, .fixed = true}),
                                    with_alteration(rope, {.particle = 5, .mass = 4})};
    std::erase_if(all, [](const RunDescription& run) { return !integrates_drag_work(run); });
    return all;
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

class DragWorkOfEqualSteps : public testing::TestWithParam<MethodCase> {};

TEST_P(DragWorkOfEqualSteps, keeps_together_with_the_energy_to_the_order_of_the_method) {
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

INSTANTIATE_TEST_SUITE_P(Methods, DragWorkOfEqualSteps, testing::ValuesIn(methods_where([](const MethodCase& c) {
                             return c.precision == Precision::double_ && has_fixed_steps(c) && is_integrated(c);
                         })),
                         case_name);

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

TEST_P(DragWorkOf, counting_that_begins_on_the_way_counts_from_there) {
    const auto [info, precision] = GetParam();
    for (const RunDescription& run : scenes(info->id, precision, 0.02)) {
        Simulation whole(run), part(run);
        ASSERT_TRUE(whole.count_drag_work());
        whole.advance(33), part.advance(33);
        const double before = *whole.drag_work();
        ASSERT_TRUE(part.count_drag_work());
        EXPECT_EQ(part.drag_work(), 0);
        whole.advance(20), part.advance(20);
        // two sums of as many terms in another order
        EXPECT_NEAR(*part.drag_work(), *whole.drag_work() - before, 1e-13 * (1 + before)) << command_line(run);
        EXPECT_EQ(part.hash(), whole.hash());
    }
}

TEST_P(DragWorkOf, goes_back_with_a_saved_state) {
    const auto [info, precision] = GetParam();
    for (const RunDescription& run : scenes(info->id, precision, 0.02)) {
        Simulation simulation(run);
        ASSERT_TRUE(simulation.count_drag_work());
        simulation.advance(21);
        const Simulation::Snapshot saved = simulation.save();
        const double there = *simulation.drag_work();
        simulation.advance(30);
        const double then = *simulation.drag_work();
        EXPECT_GT(then, there);
        RunDescription other = run;
        other.dt = 0.01;
        simulation.change(other);
        simulation.advance(3);
        EXPECT_GT(*simulation.drag_work(), then);
        simulation.restore(saved);
        EXPECT_EQ(simulation.drag_work(), there) << command_line(run);
        simulation.advance(30);
        EXPECT_EQ(simulation.drag_work(), then) << command_line(run);
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

/// Methods whose steps follow from a tolerance.
std::vector<MethodCase> tolerant_methods() {
    return methods_where([](const MethodCase& c) {
        const RunDescription run = run_of("rope", c.info->id, c.precision, 0.1);
        return c.precision == Precision::double_ && integrates_drag_work(run) &&
               run.method_parameters.contains("tolerance");
    });
}

class DragWorkToTolerance : public testing::TestWithParam<MethodCase> {};

// Frames are within the steps of the method.
TEST_P(DragWorkToTolerance, energy_and_work_keep_together_within_the_tolerance) {
    const std::string_view id = GetParam().info->id;
    for (RunDescription run : scenes(id, Precision::double_, 0.037)) {
        SCOPED_TRACE(command_line(run));
        for (const double tolerance : {1e-5, 1e-8, 1e-11}) {
            run.method_parameters.set("tolerance", tolerance);
            const double change = measured(run, run.dt, false).energy_error;
            EXPECT_GT(change, 1e-3);
            // tolerances are of positions and velocities of some units in each of some hundred steps
            EXPECT_LE(measured(run, run.dt).energy_error, std::max(300 * tolerance, 1e-12) * (1 + change)) << tolerance;
        }
    }
}

// Steps are the same whatever frames are read on the way, and so is their work.
TEST_P(DragWorkToTolerance, is_that_of_the_steps_whatever_frames_are_read) {
    for (RunDescription run : scenes(GetParam().info->id, Precision::double_, 1.0 / 4)) {
        run.method_parameters.set("tolerance", 1e-6);
        RunDescription finer = run;
        finer.dt = 1.0 / 256;
        Simulation simulation(run), often(finer);
        ASSERT_TRUE(simulation.count_drag_work() && often.count_drag_work());
        // the first step of the others, or its unit of time, follows from dt
        const double allowed = GetParam().id().starts_with("dop") ? 0 : 300 * 1e-6;
        for (int i = 0; i < 4; ++i) {
            simulation.advance(1);
            for (int j = 0; j < 64; ++j) {
                const double before = *often.drag_work();
                often.advance(1);
                EXPECT_GE(*often.drag_work(), before);
            }
            EXPECT_NEAR(*often.drag_work(), *simulation.drag_work(), allowed * *simulation.drag_work())
                << command_line(run);
        }
    }
}

// A frame within a step has what a run has that ends there.
TEST_P(DragWorkToTolerance, within_a_step_is_that_of_a_run_that_ends_there) {
    for (RunDescription run : scenes(GetParam().info->id, Precision::double_, 0.3)) {
        run.method_parameters.set("tolerance", 1e-10);
        Simulation frames(run);
        ASSERT_TRUE(frames.count_drag_work());
        frames.advance(3);
        run.dt = frames.time() * (1 + 1e-15);  // one frame, at the end
        Simulation ends(run);
        ASSERT_TRUE(ends.count_drag_work());
        ends.advance(1);
        EXPECT_NEAR(*ends.drag_work(), *frames.drag_work(), 1e-8 * *frames.drag_work());
    }
}

// Particles that pass through each other: the step across a collision has its work as well, be it small.
TEST_P(DragWorkToTolerance, goes_on_across_collisions) {
    const RunDescription run =
        run_to_tolerance("chain", GetParam().info->id, 0.05, 1e-9, {{"n", 3}, {"c", 0.2}, {"v0", 20}});
    Simulation simulation(run);
    ASSERT_TRUE(simulation.count_drag_work());
    const double start = simulation.energy();
    simulation.advance(100);
    EXPECT_GT(simulation.collisions().count(), 0u);
    EXPECT_LT(simulation.energy(), 0.5 * start);
    EXPECT_NEAR(simulation.energy_error(), 0, 300 * 1e-9 * start);
}

INSTANTIATE_TEST_SUITE_P(Methods, DragWorkToTolerance, testing::ValuesIn(tolerant_methods()), case_name);

// What the rule conserves: on springs that are linear in the displacements the energy and the work exactly, c V^2 of
// the middle of each step.
TEST(DragWork, of_the_implicit_midpoint_rule_keeps_the_energy_of_linear_scenes) {
    for (const double dt : {0.01, 0.3, 2.0}) {
        Simulation simulation(run_of("oscillator", "implicit-midpoint", Precision::double_, dt, {{"c", 0.4}}));
        ASSERT_TRUE(simulation.count_drag_work());
        simulation.advance(200);
        EXPECT_GT(*simulation.drag_work(), 0.01);
        EXPECT_NEAR(simulation.energy_error(), 0, 1e-13) << dt;  // 200 steps of some roundings of 1 J
    }
}

TEST(DragWork, is_counted_for_splittings_and_runge_kutta_methods) {
    std::string names;
    for (const Method& method : methods()) {
        if (integrates_drag_work(describe("rope", method.info.id))) names += std::string(method.info.id) + " ";
        EXPECT_FALSE(integrates_drag_work(describe("chain", method.info.id))) << method.info.id;
    }
    EXPECT_EQ(names,
              "euler midpoint rk4 velocity-verlet forest-ruth pefrl mclachlan-atela-5 srkn-11b kahan-li-8 "
              "euler-forward dopri5 dop853 implicit-midpoint tr-bdf2 taylor gauss-16 ias15 ");
}

TEST(DragWork, is_none_where_it_is_not_counted) {
    Simulation simulation(describe("rope", "rk4"));
    EXPECT_EQ(simulation.drag_work(), std::nullopt);
    Simulation other(describe("rope", "stoermer"));
    EXPECT_FALSE(other.count_drag_work());
    EXPECT_EQ(other.drag_work(), std::nullopt);
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

TEST(DragWork, begins_again_with_the_baseline) {
    for (const std::string_view id : {"rk4", "dopri5", "gauss-16"}) {
        Simulation simulation(run_of("rope", id, Precision::double_, 0.01));
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
}

TEST(DragWork, goes_on_with_another_method_that_has_it) {
    RunDescription run = run_of("rope", "rk4", Precision::double_, 0.005, {{"k", 20}, {"c", 0.3}});
    Simulation simulation(run);
    ASSERT_TRUE(simulation.count_drag_work());
    for (const std::string_view id : {"dop853", "gauss-16", "velocity-verlet", "dopri5", "tr-bdf2", "rk4"}) {
        simulation.advance(50);
        const double before = *simulation.drag_work();
        RunDescription next = describe("rope", id);
        next.scene = run.scene;
        next.dt = 0.005;
        simulation.change(next);
        EXPECT_NEAR(*simulation.drag_work(), before, 1e-14 * before) << id;  // one more sum
    }
    simulation.advance(50);
    EXPECT_GT(*simulation.drag_work(), 1);
    // that of a run of velocity Verlet alone, 4e-5
    EXPECT_NEAR(simulation.energy_error(), 0, 1e-4);
    RunDescription without = describe("rope", "stoermer");
    without.scene = run.scene;
    simulation.change(without);
    EXPECT_EQ(simulation.drag_work(), std::nullopt);
}

}  // namespace
}  // namespace steplab::test
