#include "lab/limits/blow_up.hpp"

#include "lab/limits/remedy_trial.hpp"
#include "lab/limits/replayed_run.hpp"
#include "sim/run/linear_limit.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The run to its divergence.
Simulation diverged(const RunDescription& run, std::uint64_t most = 100000) {
    Simulation simulation(run);
    simulation.advance(most);
    simulation.conclude();
    return simulation;
}

BlowUp studied(std::span<const SegmentBegin> changes, const Divergence& divergence) {
    BlowUpStudy study(changes, divergence);
    while (study.next()) {
    }
    return study.found();
}

BlowUp blow_up_of(const RunDescription& run) {
    const Simulation simulation = diverged(run);
    EXPECT_TRUE(simulation.divergence()) << command_line(run);
    return studied(std::vector<SegmentBegin>{{0, run}}, *simulation.divergence());
}

double scale_of(const Diagnostics& diagnostics) { return diagnostics.kinetic + std::abs(diagnostics.potential); }

/// Found by looking at every step.
std::uint64_t last_good_step(const RunDescription& run, std::uint64_t end) {
    Simulation simulation(run);
    const double scale = scale_of(simulation.diagnostics());
    std::uint64_t last = 0;
    for (; simulation.step() < end; simulation.advance(1)) {
        if (simulation.energy_error() <= 0.01 * scale) last = simulation.step();
    }
    return last;
}

/// Ten masses between walls that vibrate in their slowest mode: what grows of others has grown from rounding.
const std::string slow_row = row_between_walls(10) + "[start]\nmode = 1\namplitude = 0.01\n";

TEST(BlowUp, beyond_the_limit_is_that_of_the_oscillation) {
    const double omega = 4 * std::sin(std::numbers::pi * 10 / 22);  // 2 sqrt(k / m) sin(j pi / 2 (n + 1)), j = n = 10
    for (const char* const method : {"velocity-verlet", "euler", "pefrl", "rk4"}) {
        RunDescription run = with_method(describe(read_scene(slow_row)), method);
        run.dt = 1.02 * linear_limit(run, omega);
        const BlowUp found = blow_up_of(run);
        EXPECT_GT(found.step, 10u) << method;
        EXPECT_EQ(found.step, last_good_step(run, found.divergence.step)) << method;
        EXPECT_NEAR(found.limit.oscillation.omega, omega, 1e-4) << method;
        EXPECT_NEAR(run.dt / *found.limit.limit, 1.02, 1e-4) << method;
        EXPECT_GT(found.share, 0.9) << method << ": it grows fastest";
        const double growth = step_growth(steplab::method(run.method), run.method_parameters, omega, 0, run.dt);
        ASSERT_TRUE(found.growth) << method;
        // a hundredfold in six steps of the fastest: a quarter for the swing within a period, and others that grow with
        // it
        EXPECT_NEAR(*found.growth, growth * growth, 0.25 * growth * growth) << method;
        EXPECT_THAT(found.why, HasSubstr("1.02 times the stability limit")) << method;
        EXPECT_THAT(found.why, HasSubstr("% of the kinetic energy")) << method;
    }
}

// However far beyond the limit.
TEST(BlowUp, grows_by_the_factor_of_the_oscillation_or_by_none) {
    const double omega = 4 * std::sin(std::numbers::pi * 10 / 22);
    for (const char* const method : {"velocity-verlet", "verlet", "euler", "rk4"}) {
        for (const double factor : {1.005, 1.01, 1.02, 1.05, 1.1, 1.2, 1.5, 2.0, 3.0}) {
            SCOPED_TRACE(std::string(method) + ", " + std::to_string(factor));
            RunDescription run = with_method(describe(read_scene(slow_row)), method);
            run.dt = factor * linear_limit(run, omega);
            const BlowUp found = blow_up_of(run);
            const double growth = step_growth(steplab::method(run.method), run.method_parameters, omega, 0, run.dt);
            if (factor <= 1.02 && std::string(method) != "euler") {  // whose energy swings by more within a period
                EXPECT_TRUE(found.growth);
            }
            if (found.growth) {
                EXPECT_NEAR(*found.growth, growth * growth, 0.25 * growth * growth) << "as above";
            } else {
                EXPECT_THAT(found.why, HasSubstr(" later it was impossible"));
            }
        }
    }
}

// From rest, and without any energy at the start: there is nothing to measure its error by but the bound itself.
TEST(BlowUp, of_a_scene_at_rest_is_measured_by_the_bound) {
    RunDescription run = with_method(describe("rope"), "velocity-verlet");
    run.dt = 3 * stability_limit(run)->limit;
    const BlowUp found = blow_up_of(run);
    EXPECT_GT(found.divergence.step, found.step);
    EXPECT_FALSE(found.growth) << "there are too few steps";
    EXPECT_THAT(found.why, HasSubstr(" steps later it was impossible"));
}

TEST(BlowUp, of_a_method_without_limit_says_so) {
    const BlowUp found = blow_up_of(run_of("chain", "euler-forward", Precision::double_, 0.3));
    EXPECT_THAT(found.why, HasSubstr("makes every oscillation larger at any dt"));
    EXPECT_EQ(found.limit.limit, 0);
}

TEST(BlowUp, of_a_curiosity_names_the_mistake) {
    const BlowUp found = blow_up_of(run_of("chain", "stoermer-2008", Precision::double_, 0.8));
    EXPECT_THAT(found.why, HasSubstr("repeats a mistake of 2008"));
}

/// A fast bullet: the pair stiffens as it is driven together, far beyond what it has at its start.
RunDescription violent() {
    return run_of("morse", "velocity-verlet", Precision::double_, 0.1, {{"edge", 1}, {"k", 50}, {"v0", 4}});
}

TEST(BlowUp, of_a_scene_that_stiffens_says_when) {
    RunDescription run = violent();
    for (run.dt = 0.02; !diverged(run, 20000).divergence(); run.dt *= 1.1) ASSERT_LT(run.dt, 1);
    const BlowUp found = blow_up_of(run);
    EXPECT_GT(found.limit.oscillation.omega, found.start.oscillation.omega);
    EXPECT_GT(run.dt, *found.limit.limit);
    EXPECT_GE(found.limit.step, found.step);
    EXPECT_THAT(found.why, HasSubstr("particles 0 and 1"));
}

// From far apart to on top of each other in one step: no step stands where the force is.
TEST(BlowUp, of_an_encounter_within_one_step_finds_it_on_the_way) {
    RunDescription run = violent();
    run.dt = 0.5;
    const BlowUp found = blow_up_of(run);
    EXPECT_EQ(found.step, found.divergence.step) << "the energy was right, and then impossible";
    EXPECT_GT(run.dt, *found.limit.limit);
    EXPECT_GT(found.limit.time, found.divergence.time);
    EXPECT_LE(found.limit.time, found.divergence.time + run.dt);
    EXPECT_THAT(found.why, HasSubstr("stiffened"));
}

TEST(BlowUp, follows_what_was_done_to_the_run) {
    RunDescription calm = run_of("chain", "velocity-verlet", Precision::double_, 0.1), wild = calm;
    wild.dt = 1.1;
    Simulation simulation(calm);
    simulation.advance(300);
    simulation.act(Kick{3, {0, 0.5, 0}});
    simulation.advance(100);
    simulation.change(wild);
    simulation.advance(100000);
    ASSERT_TRUE(simulation.divergence());
    const std::vector<SegmentBegin> changes{
        {0, calm}, {.step = 300, .description = calm, .act = Kick{3, {0, 0.5, 0}}}, {400, wild}};
    ReplayedRun replayed(changes);
    replayed.advance_to(simulation.step());
    EXPECT_EQ(replayed.run().hash(), simulation.hash());
    const BlowUp found = studied(changes, *simulation.divergence());
    EXPECT_GE(found.step, 400u);
    EXPECT_EQ(found.run, wild);
    EXPECT_THAT(found.why, HasSubstr("dt = 1.1 s"));
    // the partner: without what was done, nothing blows up there
    EXPECT_FALSE(diverged(calm, simulation.divergence()->step).divergence());
}

/// Every method on scenes of each kind, beyond its limit or where the motion is too violent for it.
std::vector<RunDescription> runs_that_diverge() {
    std::vector<RunDescription> runs;
    for (const MethodCase& c : methods_where(has_equal_steps)) {
        if (c.precision == Precision::float_) continue;  // judged alike
        for (const char* const model : {"oscillator", "chain", "mesh", "rope", "morse"}) {
            for (const double phase : {1.2, 2.1, 2.9, 7.0}) {
                RunDescription run = run_of(model, c.id(), c.precision, 1);
                run.dt = phase / fastest_frequency(run);
                if (c.info->implicit || !diverged(run, 4000).divergence()) continue;
                runs.push_back(run);
            }
        }
    }
    return runs;
}

TEST(BlowUp, is_explained_for_every_method_and_scene) {
    std::size_t count = 0, cured = 0;
    for (const RunDescription& run : runs_that_diverge()) {
        SCOPED_TRACE(command_line(run));
        const BlowUp found = blow_up_of(run);
        ++count;
        EXPECT_LE(found.step, found.divergence.step);
        EXPECT_GE(found.limit.step, found.step);
        EXPECT_LE(found.share, 1 + 1e-9);
        EXPECT_THAT(found.why, HasSubstr("the energy was at most 1 % too high"));
        EXPECT_TRUE(found.complete);
        if (!method(run.method).info.curiosity && run.dt > *found.start.limit) {
            EXPECT_THAT(found.why, Not(HasSubstr("below the stability limit")));
        }
        for (const TriedRemedy& tried : found.tried) {
            if (!tried.works) continue;
            ++cured;
            Simulation again(tried.run);
            if (tried.from == 0) again.advance(steps_until(tried.until, tried.run.dt));
            EXPECT_FALSE(again.divergence()) << command_line(tried.run);
        }
    }
    EXPECT_GT(count, 60u);
    EXPECT_GT(cured, count) << "as a rule a dt and a method";
}

// Of what it was when it diverged: the method and the springs of its start are no longer there.
TEST(BlowUp, is_judged_by_the_run_as_it_was_at_the_end) {
    const RunDescription begun = run_of("chain", "euler-forward", Precision::double_, 0.05);
    RunDescription wild = with_method(begun, "velocity-verlet");
    wild.dt = 1.1;
    wild.scene.set("k", 2);
    Simulation simulation(begun);
    simulation.advance(20);
    simulation.change(wild);
    simulation.advance(100000);
    ASSERT_TRUE(simulation.divergence());
    const BlowUp found = studied(std::vector<SegmentBegin>{{0, begun}, {20, wild}}, *simulation.divergence());
    EXPECT_NEAR(found.start.oscillation.omega, 1.97272261 * std::sqrt(2), 1e-3);
    EXPECT_NEAR(found.start.limit.value(), 2 / found.start.oscillation.omega, 1e-9);
    EXPECT_THAT(found.why, Not(HasSubstr("inf")));
    EXPECT_THAT(found.why, HasSubstr("of velocity-verlet"));
}

TEST(BlowUp, in_the_first_step_has_remedies_with_a_cost) {
    const BlowUp found = blow_up_of(run_of("chain", "velocity-verlet", Precision::double_, 500));
    EXPECT_EQ(found.divergence.step, 0u);
    for (const TriedRemedy& tried : found.tried) {
        if (!tried.works) continue;
        EXPECT_TRUE(std::isfinite(tried.cost) && tried.cost > 0) << tried.cost;
    }
}

// Before it diverged, the run had taken shorter steps and other methods.
TEST(BlowUp, has_remedies_whose_cost_is_counted_by_the_steps_that_diverged) {
    for (const char* const id : {"rk4", "velocity-verlet"}) {
        const RunDescription begun = run_of("chain", "rk4", Precision::double_, 0.01);
        const RunDescription wild = run_of("chain", id, Precision::double_, 2);
        Simulation simulation(begun);
        simulation.advance(800);
        simulation.change(wild);
        simulation.advance(100000);
        ASSERT_TRUE(simulation.divergence());
        const BlowUp found = studied(std::vector<SegmentBegin>{{0, begun}, {800, wild}}, *simulation.divergence());
        bool same_method = false;
        for (const TriedRemedy& tried : found.tried) {
            if (!tried.works || tried.run.method != id) continue;
            same_method = true;
            EXPECT_NEAR(tried.cost, 2 / tried.run.dt, 0.1 * 2 / tried.run.dt) << id;  // a trial begins with one more
        }
        EXPECT_TRUE(same_method);
    }
}

TEST(BlowUp, is_the_same_each_time) {
    const RunDescription run = run_of("chain", "rk4", Precision::double_, 1.6);
    const BlowUp one = blow_up_of(run), other = blow_up_of(run);
    EXPECT_EQ(one.why, other.why);
    ASSERT_EQ(one.tried.size(), other.tried.size());
    for (std::size_t i = 0; i < one.tried.size(); ++i) {
        EXPECT_EQ(one.tried[i].run, other.tried[i].run);
        EXPECT_EQ(one.tried[i].energy_error, other.tried[i].energy_error);
    }
}

RemedyTrial trial_of(const RunDescription& run, std::uint64_t good) {
    Simulation simulation(run);
    simulation.advance(good);
    const Simulation end = diverged(run);
    return {simulation.save(), run, end.time(), static_cast<double>(end.evaluations()) / end.time()};
}

TEST(RemedyTrial, fails_what_does_not_help) {
    const RunDescription run = run_of("chain", "velocity-verlet", Precision::double_, 1.1);
    const RemedyTrial trial = trial_of(run, 5);
    EXPECT_FALSE(trial.of(run).works) << "the run itself";
    RunDescription smaller = run;
    smaller.dt = 0.1;
    const TriedRemedy cured = trial.of(smaller);
    EXPECT_TRUE(cured.works);
    EXPECT_NEAR(cured.cost, 11, 1);  // as many evaluations per step; both begin with one more
    EXPECT_LT(cured.energy_error.value(), 0.01);
    EXPECT_FALSE(trial.of(with_method(run, "euler-forward")).works);
}

// Stable, but it gains energy: 1.001 in size per step at this dt.
TEST(RemedyTrial, fails_what_spoils_the_energy) {
    RunDescription run = run_of("oscillator", "velocity-verlet", Precision::double_, 2.05);
    RunDescription gains = with_method(run, "midpoint");
    gains.dt = 0.3;
    const TriedRemedy tried = trial_of(run, 2).of(gains);
    EXPECT_FALSE(tried.works);
    EXPECT_GT(tried.energy_error.value_or(1), 0.1);
}

// Too long from the start: it begins before the energy went wrong, and gets past where the run diverged.
TEST(RemedyTrial, of_a_long_run_begins_late) {
    RunDescription run = run_of("mesh", "velocity-verlet", Precision::double_, 0.05, {{"dim", 60}});
    Simulation simulation(run);
    simulation.advance(1000);
    RunDescription shorter = run;
    shorter.dt = 0.001;
    const RemedyTrial trial(simulation.save(), run, simulation.time() + 0.05, 20);
    const TriedRemedy tried = trial.of(shorter);
    EXPECT_EQ(tried.from, simulation.time());
    EXPECT_GT(tried.until, tried.from);
}

}  // namespace
}  // namespace steplab::test
