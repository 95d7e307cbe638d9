// What is known in closed form of runs to which something was done at step 0.

#include "sim/run/simulation.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace steplab::test {
namespace {

/// 10 particles on springs in a line, slow enough that none passes another after what is done to them.
Simulation chain() { return Simulation(run_of("chain", "rk4", Precision::double_, 0.001, {{"v0", 0.25}})); }

RunDescription altered(const Simulation& run, std::vector<Alteration> all) {
    return with_alterations(run.description(), all);
}

Pull pull() { return {4, chain().frame().positions[4] + Vec3{0.0625, 0, 0}}; }

/// Of the largest error over some periods; of RK4 with 6000 steps per period, (2 pi / 6000)^4 and rounding.
constexpr double small = 1e-10;

double error_after(Simulation& run, std::uint64_t steps) {
    run.advance(steps);
    return run.diagnostics().error.value_or(infinity);
}

TEST(MotionFromStart, of_masses_and_fixed_particles_altered_at_step_0_is_known) {
    for (const Alteration& one :
         {Alteration{3, std::nullopt, 2.5}, Alteration{3, true}, Alteration{0, false}, Alteration{9, false, 0.5}}) {
        Simulation run = chain();
        run.change(altered(run, {one}));
        EXPECT_TRUE(run.has_exact());
        EXPECT_EQ(run.why_not_exact(), "");
        EXPECT_LT(error_after(run, 5000), small) << one.particle;
        Simulation begun(run.description());
        EXPECT_LT(error_after(begun, 5000), small) << "as after a restart";
        EXPECT_EQ(begun.hash(), run.hash());
    }
}

// Nothing moves then, and there is no mode to look for.
TEST(MotionFromStart, where_all_particles_are_fixed_is_that_they_stay) {
    Simulation run = chain();
    std::vector<Alteration> all;
    for (std::size_t i = 0; i < run.particles(); ++i) all.push_back({i, true});
    run.change(altered(run, all));
    EXPECT_EQ(error_after(run, 100), 0);
}

TEST(MotionFromStart, of_acts_along_the_line_at_step_0_is_known) {
    const std::vector<Act> acts{pull(), Kick{4, {0.125, 0, 0}}, TurnRound{}};
    for (const Act& act : acts) {
        Simulation run = chain();
        run.act(act);
        EXPECT_TRUE(run.has_exact()) << act.index();
        EXPECT_LT(error_after(run, 5000), small) << act.index();
        Simulation plain = chain();
        plain.advance(5000);
        EXPECT_GT(length(plain.frame().positions[4] - run.frame().positions[4]), 1e-3) << "it is another motion";
    }
}

TEST(MotionFromStart, is_of_all_that_was_done_there_in_its_order) {
    Simulation run = chain();
    run.act(pull());
    run.change(altered(run, {{4, std::nullopt, 3.0}}));
    RunDescription stiffer = run.description();
    stiffer.scene.set("k", 2);
    run.change(stiffer);
    run.act(Kick{2, {0.0625, 0, 0}});
    run.change(with_method(run.description(), "pefrl"));
    EXPECT_TRUE(run.has_exact());
    EXPECT_EQ(run.frame().positions[4], pull().position);
    EXPECT_LT(error_after(run, 5000), small);
}

TEST(MotionFromStart, comes_back_with_a_saved_state_of_before) {
    Simulation run = chain();
    const auto before = run.save();
    RunDescription stiffer = run.description();
    stiffer.scene.set("k", 2);
    run.change(stiffer);
    EXPECT_LT(error_after(run, 1000), small);
    run.restore(before);
    EXPECT_LT(error_after(run, 1000), small);
}

// The partners: across the line there is no closed form, and later than at step 0 it is not looked for.
TEST(MotionFromStart, is_not_known_of_other_motions) {
    Simulation across = chain();
    across.act(Kick{4, {0, 0.5, 0}});
    EXPECT_FALSE(across.has_exact());
    EXPECT_EQ(across.why_not_exact(), "no exact solution is known from this start");
    EXPECT_FALSE(across.diagnostics().error);
    Simulation later = chain();
    later.advance(1);
    later.change(altered(later, {{3, std::nullopt, 2.5}}));
    EXPECT_FALSE(later.has_exact());
    EXPECT_EQ(later.why_not_exact(), "the scene was changed during the run");
}

}  // namespace
}  // namespace steplab::test
