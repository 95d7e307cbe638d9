#include "session/comparison.hpp"

#include "lab/study/measurement.hpp"
#include "sim/run/run_variant.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <vector>

namespace steplab::test {
namespace {

std::vector<RunDescription> variants(const RunDescription& scene, std::initializer_list<std::string_view> texts) {
    std::vector<RunDescription> runs;
    for (const std::string_view text : texts) runs.push_back(variant_of(scene, text));
    return runs;
}

RunDescription scene_of(std::string_view id, Settings settings = {}) {
    return run_of(id, "rk4", Precision::double_, 0.1, settings);
}

TEST(StepAt, is_the_last_step_that_does_not_lie_after_the_time) {
    EXPECT_EQ(step_at(0, 0.3), 0u);
    EXPECT_EQ(step_at(0.29, 0.3), 0u);
    EXPECT_EQ(step_at(0.3, 0.3), 1u);
    EXPECT_EQ(step_at(0.3 * (1 - 0.9e-6), 0.3), 1u) << "within 1e-6 dt counts as being there";
    EXPECT_EQ(step_at(0.3 * (1 - 1.1e-6), 0.3), 0u);
    EXPECT_EQ(step_at(1000, 0.1), 10000u) << "although 10000 * 0.1 is rounded";
}

TEST(RunComparison, shows_every_run_at_its_last_step_before_the_time) {
    RunComparison comparison(variants(scene_of("chain"), {"dt=0.1", "dt=0.3,method=verlet", "dt=0.25,precision=float"}),
                             6, 60);
    for (std::uint64_t sample = 0; sample <= 60; ++sample) {
        const auto all = comparison.at(sample);
        ASSERT_EQ(all.size(), 3u);
        const double time = comparison.time(sample);
        const double dts[] = {0.1, 0.3, 0.25};
        for (std::size_t i = 0; i < 3; ++i) {
            ASSERT_TRUE(all[i]);
            EXPECT_NEAR(all[i]->time, static_cast<double>(all[i]->step) * dts[i], 1e-12);
            EXPECT_LE(all[i]->time, time + 1e-6 * dts[i]);
            EXPECT_GT(all[i]->time + dts[i], time);
        }
    }
}

// The steps of such a method do not depend on dt: it is evaluated where the others are sampled.
TEST(RunComparison, evaluates_methods_of_own_steps_at_the_time_itself) {
    RunComparison comparison(variants(scene_of("mesh", {{"dim", 5}}), {"method=dopri5,dt=0.7", "method=ias15,dt=3"}), 6,
                             60);
    for (const std::uint64_t sample : {0U, 1U, 17U, 60U}) {
        for (const auto& compared : comparison.at(sample)) {
            ASSERT_TRUE(compared);
            EXPECT_NEAR(compared->time, comparison.time(sample), 1e-14);
        }
    }
}

TEST(RunComparison, of_a_scene_with_a_closed_form_has_its_error) {
    for (const Precision precision : precisions) {
        RunDescription run = run_of("chain", "rk4", precision, 0.25);
        RunComparison comparison({run, run}, 50, 10);
        Simulation alone(run);
        for (std::uint64_t sample = 0; sample <= 10; ++sample) {
            const auto all = comparison.at(sample);
            alone.advance(step_at(comparison.time(sample), alone.dt()) - alone.step());
            const Diagnostics right = alone.diagnostics();
            // the closed form of the same numbers, summed in another order
            EXPECT_NEAR(all[0]->error, *right.error, 1e-14);
            EXPECT_EQ(all[0]->error, all[1]->error);
            EXPECT_EQ(all[0]->energy_error, right.energy_error);
            EXPECT_EQ(all[0]->evaluations, alone.evaluations());
            EXPECT_EQ(all[0]->reference_error, 0);
            EXPECT_LE(all[0]->rms_error, all[0]->error);
            EXPECT_GE(all[0]->rms_error, all[0]->error / 3) << "nine moving particles";
        }
        EXPECT_GT(comparison.at(10)[0]->error, 1e-6);
    }
}

// The lab's reference is of the same family with other steps.
// Of one frequency, methods of order 2 turn at another: the phase they have won or lost grows with time.
TEST(RunComparison, knows_by_how_much_a_run_is_ahead_of_the_motion) {
    constexpr double dt = 0.1, until = 40;
    for (const Precision precision : {Precision::float_, Precision::double_}) {
        const auto oscillator = [&](std::string_view method) {
            return run_of("oscillator", method, precision, dt, {{"k", 1}, {"m", 1}, {"c", 0}, {"v0", 1}});
        };
        RunComparison comparison({oscillator("velocity-verlet"), oscillator("implicit-midpoint")}, until, 20);
        for (int sample = 1; sample <= 20; ++sample) {
            const auto runs = comparison.at(static_cast<std::uint64_t>(sample));
            const double time = runs[0]->time;
            const double verlet = (2 / dt * std::asin(dt / 2) - 1) * time,
                         midpoint = (2 / dt * std::atan(dt / 2) - 1) * time;
            // what the amplitude is off, (omega dt)^2 / 8, counts as phase by x / v; so does the square of the shift
            const double slope = std::abs(std::tan(time)), second = dt * dt / 8 + midpoint * midpoint;
            const double tolerance = 2e-3 * std::abs(midpoint) + second * (1 + slope);
            EXPECT_NEAR(runs[0]->phase_error.value(), verlet, tolerance) << time;
            EXPECT_NEAR(runs[1]->phase_error.value(), midpoint, tolerance) << time;
        }
    }
}

TEST(RunComparison, agrees_with_measurements_of_the_lab) {
    for (const auto& [scene, time] : {std::pair(scene_of("mesh", {{"dim", 5}}), 10.0), std::pair(scene_of("rope"), 3.0),
                                      std::pair(scene_of("morse", {{"spacing", 0.3}}), 1.0)}) {
        const auto runs = variants(scene, {"method=velocity-verlet,dt=0.01", "method=rk4,dt=0.01",
                                           "method=midpoint,dt=0.01", "method=rk4,dt=0.01,precision=float"});
        RunComparison comparison(runs, time, 4);
        const auto end = comparison.at(4);
        const Reference right = reference(scene, std::vector<double>{time});
        for (std::size_t i = 0; i < runs.size(); ++i) {
            SCOPED_TRACE(command_line(runs[i]));
            const Measurement lab = measure(runs[i], step_at(time, 0.01), right);
            ASSERT_TRUE(end[i]);
            // the step of a run in float ends beside the time by the rounding of dt; no speed is above 2 m/s
            const double beside = 2 * std::abs(end[i]->time - time);
            EXPECT_NEAR(end[i]->error, lab.error, 0.01 * lab.error + beside);
            EXPECT_EQ(end[i]->evaluations, lab.result.evaluations);
        }
    }
}

TEST(RunComparison, knows_what_a_scene_lets_a_method_keep) {
    const auto one = [](const RunDescription& scene) {
        RunComparison comparison({scene, scene}, 1, 4);
        return *comparison.at(4)[0];
    };
    EXPECT_FALSE(one(scene_of("chain")).momentum_error) << "its first particle is fixed";
    const Compared free = one(scene_of("chain", {{"fixed", 0}}));
    ASSERT_TRUE(free.momentum_error);
    EXPECT_LT(*free.momentum_error, 1e-14);
    EXPECT_TRUE(one(variant_of(scene_of("rope"), "method=rk4,dt=0.01")).energy_error) << "the work of drag is counted";
    EXPECT_TRUE(one(variant_of(scene_of("rope"), "method=ias15")).energy_error);
    EXPECT_FALSE(one(variant_of(scene_of("rope"), "method=rkn-12-10")).energy_error);
}

// One of ten particles is 3 m off, one is fixed: the root of 9 m^2 over nine.
TEST(Compared, has_the_mean_over_particles_that_move) {
    const Simulation run(scene_of("chain"));
    RunMoment moment = moment_of(run, {});
    moment.displacement.set(5, moment.displacement.at(5) + Vec3{3, 0, 0});
    const Compared found = compared(moment, {0, run.state(), 0}, true);
    EXPECT_DOUBLE_EQ(found.error, 3);
    EXPECT_DOUBLE_EQ(found.rms_error, 1);
}

TEST(Compared, has_no_error_of_the_momentum_that_a_kick_gave) {
    Simulation run(scene_of("chain", {{"fixed", 0}}));
    const Vec3 start = run.diagnostics().momentum;
    run.advance(3);
    EXPECT_TRUE(moment_of(run, start).momentum_error);
    run.act(Kick{5, {0.5, 0, 0}});
    EXPECT_FALSE(moment_of(run, start).momentum_error);
}

TEST(RunComparison, goes_on_without_a_run_that_diverged) {
    RunComparison comparison(variants(scene_of("chain"), {"method=rk4,dt=2", "method=rk4,dt=0.1"}), 600, 300);
    const std::uint64_t last_good = [&] {
        std::uint64_t last = 0;
        for (std::uint64_t sample = 0; sample <= 300; ++sample) {
            const auto all = comparison.at(sample);
            EXPECT_TRUE(all[1]);
            if (all[0]) last = all[0]->step;
        }
        return last;
    }();
    ASSERT_TRUE(comparison.run(0).divergence());
    EXPECT_EQ(last_good, comparison.run(0).divergence()->step) << "no row has to be taken back";
    EXPECT_EQ(comparison.run(1).time(), 600);
}

// Runs of other parameters are compared with other motions, or the difference would be that of the parameters.
TEST(RunComparison, takes_the_motion_of_each_runs_own_parameters) {
    RunComparison comparison(variants(scene_of("chain"), {"dt=0.01", "dt=0.01,k=1.5"}), 10, 4);
    for (const auto& compared : comparison.at(4)) EXPECT_LT(compared->error, 1e-8);
}

}  // namespace
}  // namespace steplab::test
