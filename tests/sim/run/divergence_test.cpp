#include "sim/run/divergence.hpp"

#include "core/interruption.hpp"
#include "sim/run/remedy.hpp"
#include "sim/run/starting.hpp"
#include "support/asked.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <set>
#include <string>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Divergence, ends_the_run_at_the_last_good_step) {
    for (const Precision precision : precisions) {
        Simulation simulation(run_of("chain", "rk4", precision, 1.6));
        simulation.advance(100000);
        ASSERT_TRUE(simulation.divergence());
        const std::uint64_t last_good = simulation.step();
        EXPECT_EQ(simulation.divergence()->step, last_good);
        EXPECT_EQ(simulation.divergence()->time, simulation.time());
        EXPECT_TRUE(std::isfinite(simulation.diagnostics().energy));
        simulation.advance(10);
        EXPECT_EQ(simulation.step(), last_good) << "it goes no further";
    }
}

// A potential far narrower than the distance between two numbers near 9.5 m.
TEST(Divergence, of_a_method_that_chooses_its_steps_never_blames_dt) {
    std::set<std::string> stopped;
    for (const MethodCase& c :
         methods_where([](const MethodCase& m) { return ParameterValues(m.info->parameters).contains("tolerance"); })) {
        RunDescription run = run_of("morse", c.id(), c.precision, 20, {{"edge", 1}, {"k", 1e20}});
        run.method_parameters.set("tolerance", 1e-9);
        Simulation simulation(run);
        simulation.advance(1);
        if (!simulation.divergence()) continue;
        EXPECT_THAT(simulation.divergence()->message, Not(HasSubstr("dt = "))) << c;
        EXPECT_TRUE(remedy_candidates(run, plan_of(run), 1).dts.empty()) << c;
        if (!simulation.divergence()->stop) continue;
        stopped.insert(c.id());
        EXPECT_THAT(simulation.divergence()->message, HasSubstr("meets its tolerance of 1e-9")) << c;
        EXPECT_THAT(simulation.divergence()->message, HasSubstr("particles 0 and 1, ")) << c;
        EXPECT_NEAR(simulation.divergence()->stop->time, 9.5, 0.01) << c;  // where the bullet is at r0
    }
    // taylor gets through, or leaves what float holds
    EXPECT_EQ(stopped, (std::set<std::string>{"dop853", "dopri5", "gauss-16", "ias15", "rkn-12-10"}));
}

// The bullet's target is so stiff that its energy overflows at the start: neither a shorter dt nor another tolerance
// helps.
TEST(Divergence, of_energies_beyond_all_numbers_blames_neither_dt_nor_tolerance) {
    for (const MethodCase& c : methods_where([](const MethodCase&) { return true; })) {
        const bool is_double = c.precision == Precision::double_;
        RunDescription run =
            run_of("morse", c.id(), c.precision, 20, {{"edge", 3}, {"k", is_double ? 1e16 : 1e9}, {"r0", 1}});
        if (refusal_of(run)) continue;
        Simulation simulation(run);
        simulation.advance(1);
        ASSERT_TRUE(simulation.divergence()) << c;
        const std::string holds = is_double ? "double" : "float";
        EXPECT_THAT(simulation.divergence()->message,
                    HasSubstr("the energy there is more than " + holds + " holds, whatever dt is"))
            << c;
        EXPECT_THAT(simulation.divergence()->message, Not(HasSubstr("tolerance"))) << c;
    }
}

/// A process of its own: the signal has come when the step begins.
void step_interrupted(const RunDescription& run) {
    Simulation simulation(run);
    catch_interruptions();
    std::raise(SIGTERM);
    try {
        simulation.advance(1);
    } catch (const Interrupted&) {
        std::_Exit(7);
    }
    std::_Exit(0);
}

class LongStepDeathTest : public testing::TestWithParam<MethodCase> {};

TEST_P(LongStepDeathTest, is_left_in_its_middle_when_a_signal_comes) {
    EXPECT_EXIT(step_interrupted(run_of("mesh", GetParam().id(), GetParam().precision, 100)),
                testing::ExitedWithCode(7), "");
}

INSTANTIATE_TEST_SUITE_P(Methods, LongStepDeathTest,
                         testing::ValuesIn(methods_where([](const MethodCase& m) { return !has_equal_steps(m); })),
                         case_name);

TEST(Divergence, does_not_depend_on_who_looks) {
    for (const MethodCase& c : all_methods()) {
        const RunDescription description = run_of("chain", c.id(), c.precision, 3);
        Simulation at_once(description), watched(description), seldom(description);
        at_once.advance(3000);
        for (int i = 0; i < 3000; ++i) {
            watched.advance(1);
            watched.diagnostics();
        }
        for (int i = 0; i < 3000; i += 30) seldom.advance(30);
        for (Simulation* simulation : {&at_once, &watched, &seldom}) simulation->conclude();
        for (const Simulation* other : {&watched, &seldom}) {
            EXPECT_EQ(at_once.hash(), other->hash()) << c;
            EXPECT_EQ(at_once.step(), other->step()) << c;
            EXPECT_EQ(at_once.evaluations(), other->evaluations()) << c;
            EXPECT_EQ(at_once.divergence().has_value(), other->divergence().has_value()) << c;
        }
    }
}

TEST(Divergence, at_the_very_end_is_found_when_the_run_is_concluded) {
    Simulation simulation(run_of("chain", "rk4", Precision::double_, 3));
    simulation.advance(40);  // far from the next check of the energy
    EXPECT_FALSE(simulation.divergence());
    simulation.conclude();
    ASSERT_TRUE(simulation.divergence());
    EXPECT_LT(simulation.step(), 40u);
    const std::uint64_t last_good = simulation.step();
    simulation.conclude();
    EXPECT_EQ(simulation.step(), last_good);
}

TEST(Divergence, says_where_and_why_and_what_to_do) {
    Simulation simulation(run_of("chain", "rk4", Precision::double_, 1.6));
    simulation.advance(100000);
    const Divergence& divergence = *simulation.divergence();
    EXPECT_NEAR(*divergence.limit, 1.43377, 5e-6);
    EXPECT_EQ(divergence.dt, 1.6);
    EXPECT_THAT(divergence.message, HasSubstr("dt = 1.6 s is beyond the stability limit 1.434 s of rk4"));
    EXPECT_THAT(divergence.message, HasSubstr("particle " + std::to_string(divergence.particle)));
    EXPECT_THAT(divergence.message, HasSubstr("step " + std::to_string(divergence.step)));
    RunDescription remedied = simulation.description();
    remedied.dt = remedy_candidates(remedied, plan_of(remedied), fastest_frequency(remedied)).dts.front();
    Simulation again(remedied);
    again.advance(2000);
    EXPECT_EQ(again.step(), 2000u);
}

// Frequencies of which the theory makes overflows are not explained by it.
TEST(Divergence, of_the_stiffest_springs_has_the_right_reason) {
    for (const char* id : {"chain", "mesh", "rope", "oscillator"}) {
        for (const double k : {1e150, 1e250, 1e299, 1e304, 1.7e308}) {
            Simulation simulation(run_of(id, "rk4", Precision::double_, 0.1, {{"k", k}}));
            simulation.advance(1000);
            const auto& divergence = simulation.divergence();
            ASSERT_TRUE(divergence) << id << " k = " << k;
            const double soft =
                stability_limit(run_of(id, "rk4", Precision::double_, 0.1, {{"k", 1e20}}))->limit * 1e10;
            // drag, which the rope has, is nothing beside such springs
            if (divergence->limit) {
                EXPECT_NEAR(*divergence->limit * std::sqrt(k) / soft, 1, 1e-9) << id << " k = " << k;
            }
            EXPECT_EQ(divergence->limit.has_value(), k < 1e300) << id;
            EXPECT_THAT(divergence->message, Not(HasSubstr("gains energy"))) << id << " k = " << k;
        }
    }
}

TEST(Divergence, of_a_method_without_limit_says_so) {
    Simulation simulation(run_of("oscillator", "midpoint", Precision::double_, 0.9));
    simulation.advance(100000);
    EXPECT_EQ(simulation.divergence()->limit, 0);
    EXPECT_THAT(simulation.divergence()->message, HasSubstr("gains energy at any dt"));
}

TEST(Divergence, of_a_scene_without_known_limit_names_dt) {
    Simulation simulation(run_of("morse", "euler", Precision::double_, 30, {{"k", 8}, {"spacing", 0.2}}));
    simulation.advance(100000);
    ASSERT_TRUE(simulation.divergence());
    EXPECT_FALSE(simulation.divergence()->limit.has_value());
    EXPECT_THAT(simulation.divergence()->message, HasSubstr("dt = 30 s is too large for euler"));
}

TEST(Divergence, names_the_particle_that_is_thrown_off) {
    Simulation simulation(run_of("oscillator", "euler", Precision::double_, 2.5));
    simulation.advance(100000);
    EXPECT_EQ(simulation.divergence()->particle, 1u);
}

TEST(Divergence, at_once_leaves_the_start) {
    for (const Precision precision : precisions) {
        Simulation simulation(
            run_of("chain", "rk4", precision, 0.1, {{"v0", precision == Precision::float_ ? 3e38 : 1e308}}));
        simulation.advance(100);
        ASSERT_TRUE(simulation.divergence());
        EXPECT_EQ(simulation.divergence()->step, 0u);
    }
}

// There velocities of the first step are not yet seen in positions, and every energy at the start may be zero. At these
// dt every method, forward Euler included, multiplies an energy by less than 10 in as many steps.
TEST(Divergence, is_not_claimed_of_a_run_that_begins_at_rest) {
    for (const MethodCase& c : all_methods()) {
        for (const RunDescription& at_rest :
             {run_of("free", c.id(), c.precision, 0.1), run_of("free", c.id(), c.precision, 1e4),
              run_of("free", c.id(), c.precision, 1e-6, {{"n", 2}, {"m", 1e-9}}),
              run_of("rope", c.id(), c.precision, 0.01), run_of("rope", c.id(), c.precision, 1e-5),
              run_of("rope", c.id(), c.precision, 0.01, {{"L", 0}}),
              run_of("rope", c.id(), c.precision, 0.01, {{"c", 0}}),
              run_of("oscillator", c.id(), c.precision, 0.1, {{"v0", 0}}),
              run_of("chain", c.id(), c.precision, 0.1, {{"v0", 0}}),
              run_of("mesh", c.id(), c.precision, 0.1, {{"v0", 0}, {"dim", 5}}),
              run_of("morse", c.id(), c.precision, 0.01, {{"v0", 0}}),
              run_of("crystal", c.id(), c.precision, 0.01,
                     {{"kT", 0}, {"jitter", 0}, {"edge", 3}, {"spacing", 2}, {"cutoff", 2}})}) {
            for (std::uint64_t steps = 1; steps <= 6; ++steps) {
                Simulation simulation(at_rest);
                simulation.advance(steps);
                simulation.conclude();
                ASSERT_EQ(simulation.step(), steps) << c << " " << at_rest.model << " " << at_rest.dt;
            }
        }
    }
}

// The partner: as soon as a blow-up is more than what one step from rest may be, it is found.
TEST(Divergence, is_found_in_a_run_that_begins_at_rest) {
    for (const Precision precision : precisions) {
        Simulation simulation(run_of("rope", "euler-forward", precision, 0.2));
        simulation.advance(256);
        EXPECT_TRUE(simulation.divergence());
        EXPECT_LT(simulation.step(), 20u);
    }
}

// What only looks like a blow-up: falling ever faster, a method that gains energy slowly, a rope that starts with no
// energy at all, a scene in which nothing moves.
TEST(Divergence, is_not_claimed_of_usable_runs) {
    // all but forward Euler
    const auto is_usable = [](const MethodCase& c) { return c.info->order > 1 || c.info->linear_limit != 0; };
    for (const MethodCase& c : working_methods_where(is_usable)) {
        for (const auto& description :
             {run_of("free", c.id(), c.precision, 0.1), run_of("chain", c.id(), c.precision, 0.02),
              run_of("rope", c.id(), c.precision, 0.01), run_of("mesh", c.id(), c.precision, 0.1),
              run_of("chain", c.id(), c.precision, 0.1, {{"v0", 0}, {"L", 0.1}}),
              run_of("mesh", c.id(), c.precision, 0.1, {{"v0", 0}, {"L", 0.1}}),
              run_of("rope", c.id(), c.precision, 0.01, {{"g", 0}}),
              run_of("morse", c.id(), c.precision, 0.02, {{"edge", 1}, {"v0", 0}})}) {
            Simulation simulation(description);
            const std::uint64_t steps = c.info->implicit ? 300 : 5000;  // which cost as much
            simulation.advance(steps);
            EXPECT_EQ(simulation.step(), steps) << c << " " << description.model << " " << description.dt;
        }
    }
}

TEST(Divergence, is_left_behind_by_a_change) {
    Simulation simulation(run_of("chain", "rk4", Precision::double_, 1.6));
    simulation.advance(100000);
    RunDescription smaller = simulation.description();
    smaller.dt = 0.1;
    EXPECT_EQ(simulation.change(smaller), Change::continued);
    EXPECT_FALSE(simulation.divergence());
    const std::uint64_t step = simulation.step();
    simulation.advance(10);
    EXPECT_EQ(simulation.step(), step + 10);
}

TEST(Divergence, bound_is_relative_to_energies_and_work) {
    const Energy start{1, {0, 0, 0}};
    EXPECT_TRUE(energy_is_possible({1000, {0, 0, 0}}, start, 0));
    EXPECT_FALSE(energy_is_possible({1002, {0, 0, 0}}, start, 0));
    EXPECT_TRUE(energy_is_possible({1002, {0, 0, 0}}, start, 1));
    EXPECT_TRUE(energy_is_possible({1e9, {-1e9, 1e9, -1e9}}, start, 0));  // a fall: no gain
    EXPECT_TRUE(energy_is_possible({0, {-1e6, 1e6, 0}}, start, 0));       // a loss
    EXPECT_FALSE(energy_is_possible({std::nan(""), {0, 0, 0}}, start, 0));
    EXPECT_FALSE(energy_is_possible({infinity, {0, 0, 0}}, start, 0));
}

}  // namespace
}  // namespace steplab::test
