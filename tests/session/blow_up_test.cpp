#include "session/worker_test.hpp"
#include "sim/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

namespace steplab {

void PrintTo(const RunDescription& run, std::ostream* out) { *out << command_line(run); }

}  // namespace steplab

namespace steplab::test {
namespace {

/// Steps one by one until the run is said to have diverged, and sees every moment up to then.
class BlowUp : public WorkerTest, public testing::WithParamInterface<RunDescription> {
protected:
    BlowUp() : WorkerTest(GetParam()) {}

    /// The velocities that a curiosity shows are not judged.
    static bool is_beyond_bound(const RunView& shown, double start) {
        const Diagnostics& now = shown.diagnostics;
        const double energy = method(GetParam().method).info.curiosity ? now.potential : now.energy;
        return energy - start > 1000 * (std::abs(start) + 1e-6);
    }
    /// As it goes without anybody looking.
    static Simulation left_alone() {
        Simulation simulation(GetParam());
        simulation.advance(100000);
        return simulation;
    }
};

// The energy is judged on every 256th step: at two seconds a step the card would come after minutes.
TEST_P(BlowUp, is_announced_with_the_first_step_beyond_the_bound) {
    const Simulation alone = left_alone();
    ASSERT_TRUE(alone.divergence());
    const std::uint64_t last_good = alone.step();
    const double start = view.diagnostics.energy;
    for (std::uint64_t step = 1; step <= last_good; ++step) {
        worker.send(event::Step{1});
        ASSERT_TRUE(see([=](const RunView& v) { return v.frame.step == step; }));
        ASSERT_FALSE(view.divergence) << step;
        ASSERT_FALSE(is_beyond_bound(view, start)) << step;
    }
    worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.divergence.has_value(); }));
    EXPECT_EQ(view.divergence->message, alone.divergence()->message) << "the verdict is that of the grid";
    EXPECT_EQ(view.frame.step, last_good);
    EXPECT_EQ(view.frame.positions, alone.frame().positions);
    EXPECT_EQ(view.frame.velocities, alone.frame().velocities);
    EXPECT_FALSE(view.playing);
}

TEST_P(BlowUp, is_never_shown_while_playing) {
    const double start = view.diagnostics.energy;
    worker.send(event::SetRate{{true, 1}});
    worker.send(event::Play{true});
    ASSERT_TRUE(see([=](const RunView& v) {
        EXPECT_FALSE(is_beyond_bound(v, start)) << v.frame.step;
        return v.divergence.has_value();
    }));
    EXPECT_EQ(view.divergence->message, left_alone().divergence()->message);
}

// On a thread of its own, after the card; what restarts the run takes it away.
TEST_P(BlowUp, is_explained_and_remedies_are_tried) {
    worker.send(event::SetRate{{true, 1}});
    worker.send(event::Play{true});
    ASSERT_TRUE(see([&](const RunView&) { return session.blow_up && session.blow_up->complete; }));
    const Simulation alone = left_alone();
    ASSERT_TRUE(view.divergence);
    EXPECT_EQ(session.blow_up->divergence.step, alone.step());
    BlowUpStudy study(std::vector<SegmentBegin>{{0, GetParam()}}, *alone.divergence());
    while (study.next()) {
    }
    EXPECT_EQ(session.blow_up->why, study.found().why);
    EXPECT_EQ(view.frame.oscillation, study.found().limit.oscillation.shape);
    worker.send(event::Restart{});
    ASSERT_TRUE(see([](const RunView& v) { return !v.divergence; }));
    EXPECT_FALSE(session.blow_up);
}

// Back from the end, it is known again.
TEST_P(BlowUp, can_be_gone_through_again) {
    worker.send(event::SetRate{{true, 1}});
    worker.send(event::Play{true});
    ASSERT_TRUE(see([&](const RunView&) { return session.blow_up && session.blow_up->complete; }));
    const std::string why = session.blow_up->why;
    const std::uint64_t end = view.frame.step, begin = session.blow_up->step;
    worker.send(event::Seek{begin});
    ASSERT_TRUE(see([=](const RunView& v) { return !v.divergence && v.frame.step == begin; }));
    worker.send(event::Seek{end + 1});
    ASSERT_TRUE(see([&](const RunView& v) { return v.divergence && session.blow_up; }));
    EXPECT_EQ(session.blow_up->why, why);
}

std::string run_name(const testing::TestParamInfo<RunDescription>& run) {
    const RunDescription& of = run.param;
    std::string name = of.model + "_" + of.method + "_" + std::string(id(of.precision));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

// All of them start with kinetic energy alone: it is the measure of the bound.
INSTANTIATE_TEST_SUITE_P(Runs, BlowUp,
                         testing::Values(run_of("chain", "rk4", Precision::double_, 2),
                                         run_of("chain", "rk4", Precision::float_, 2),
                                         run_of("chain", "verlet", Precision::double_, 1.2),
                                         run_of("chain", "verlet-2008", Precision::double_, 1.2),
                                         run_of("oscillator", "euler", Precision::double_, 2.5),
                                         run_of("oscillator", "midpoint", Precision::double_, 0.9),
                                         run_of("mesh", "velocity-verlet", Precision::double_, 1),
                                         run_of("mesh", "rk4", Precision::float_, 1.5)),
                         run_name);

// Head on, the bullet lands on the target itself: there the energy of the pair is enormous, but no force acts, and the
// next step carries it through (at the start the force is below the smallest number). The check at step 256 finds
// nothing.
class PassingThrough : public WorkerTest {
protected:
    PassingThrough() : WorkerTest(run_of("morse", "euler", Precision::double_, 10, {{"edge", 1}, {"k", 20000}})) {}
};

TEST_F(PassingThrough, is_shown_once_a_check_has_cleared_it_of_suspicion) {
    Simulation alone(view.description);
    alone.advance(1);
    ASSERT_FALSE(alone.is_plausible());
    ASSERT_EQ(alone.steps_to_check(), 255u);
    alone.advance(255);
    ASSERT_FALSE(alone.divergence());
    worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step > 0; }));
    EXPECT_EQ(view.frame.step, 256u);
    EXPECT_FALSE(view.divergence);
    EXPECT_EQ(view.frame.positions, alone.frame().positions);
}

/// Dozens of milliseconds of steps lie between the first impossible energy and the check that judges it.
TEST(Worker, tells_of_an_impossible_energy_until_it_is_judged) {
    RunDescription mesh = run_of("mesh", "rk4", Precision::double_, 3);
    mesh.scene.set("dim", 200);
    Simulation alone(mesh);
    while (alone.is_plausible()) alone.advance(1);
    static Worker* asked = nullptr;
    static std::vector<Doubt> told;
    told.clear();
    Worker worker(mesh);
    asked = &worker;
    worker.on_view([] {
        if (const auto doubt = asked->doubt()) told.push_back(*doubt);
        News::wake();
    });
    SessionView session;
    const RunView& view = session.leading;
    for (std::uint64_t step = 0; step < alone.step(); ++step) worker.send(event::Step{1});
    while (!view.divergence) {
        while (worker.take(session)) {
        }
        ASSERT_TRUE(view.divergence || News::wait());
    }
    EXPECT_FALSE(worker.doubt()) << "it was judged";
    ASSERT_FALSE(told.empty());
    for (const Doubt& doubt : told) {
        EXPECT_GT(doubt.step, view.divergence->step) << "which is the last good one";
        EXPECT_GE(doubt.now, doubt.step);
        EXPECT_LT(doubt.now, doubt.check);
        EXPECT_EQ(doubt.check, 256u);
    }
}

}  // namespace
}  // namespace steplab::test
