#include "session/worker_test.hpp"

#include "sim/ensemble/live_ensemble.hpp"
#include "support/allocations.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <new>
#include <vector>

namespace steplab::test {
namespace {

TEST_F(WorkerTest, shows_the_start_at_once) {
    EXPECT_EQ(view.frame.step, 0u);
    EXPECT_EQ(view.frame.positions.size(), 10u);
    EXPECT_FALSE(view.playing);
    EXPECT_FALSE(view.can_step_back);
    EXPECT_TRUE(view.has_exact);
    ASSERT_TRUE(view.limit);
    EXPECT_NEAR(view.limit->limit, 1.43377, 5e-6);
    while (worker.take(session)) EXPECT_EQ(view.frame.step, 0u);  // ends: each view is taken once
}

TEST_F(WorkerTest, steps_on_and_back) {
    worker.send(event::Step{1});
    worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 2; }));
    EXPECT_TRUE(view.can_step_back);
    EXPECT_EQ(view.frame.positions, frame_after(view.description, 2).positions);
    worker.send(event::Step{-1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 1; }));
    EXPECT_EQ(view.frame.positions, frame_after(view.description, 1).positions);
    worker.send(event::Step{-1});
    worker.send(event::Step{-1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 0; }));
    EXPECT_FALSE(view.can_step_back);
}

TEST_F(WorkerTest, goes_to_a_step_and_stays_there) {
    worker.send(event::Seek{100'003});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 100'003 && !v.goal; }));
    EXPECT_FALSE(view.playing);
    EXPECT_TRUE(view.can_step_back);
    EXPECT_EQ(view.frame.positions, frame_after(view.description, 100'003).positions);
}

TEST_F(WorkerTest, shows_its_way_to_a_step_and_takes_other_commands_on_it) {
    static constexpr std::uint64_t far = 1'000'000'000'000;
    const auto under_way = [](const RunView& v) { return v.goal == far && v.frame.step > 0; };
    const std::vector<std::function<void()>> commands{
        [this] { worker.send(event::Play{false}); },
        [this] { worker.send(event::Step{-1}); },
        [this] { worker.send(event::Step{1}); },
        [this] { worker.send(event::Change{with_method(view.description, "verlet")}); },
        [this] {
            worker.send(event::Do{Pull{9, {9, 1, 0}}});
        },
        [this] { worker.send(event::Restart{}); }};
    for (const auto& command : commands) {
        worker.send(event::Seek{far});
        ASSERT_TRUE(see(under_way));
        command();
        EXPECT_TRUE(see([](const RunView& v) { return !v.goal; }));
    }
    worker.send(event::Seek{far});
    worker.send(event::SetRate{{false, 2}});
    EXPECT_TRUE(see([](const RunView& v) { return v.goal == far && v.rate.seconds_per_second == 2; }));
}

TEST_F(WorkerTest, plays_backwards_until_the_start_also_from_where_the_run_diverged) {
    worker.send(event::SetRate{{true}});
    worker.send(event::Change{run_of("chain", "rk4", Precision::double_, 2)});
    worker.send(event::Play{true});
    ASSERT_TRUE(see([](const RunView& v) { return v.divergence.has_value(); }));
    worker.send(event::SetRate{{false, 20}});
    worker.send(event::Play{true, true});
    ASSERT_TRUE(see([](const RunView& v) { return v.playing && !v.divergence; }));
    EXPECT_TRUE(session.line.backwards);
    worker.send(event::SetRate{{true}});
    ASSERT_TRUE(see([](const RunView& v) { return !v.playing && v.frame.step == 0; }));
}

TEST_F(WorkerTest, plays_until_it_is_paused) {
    worker.send(event::SetRate{{true, 1}});
    worker.send(event::Play{true});
    ASSERT_TRUE(see([](const RunView& v) { return v.playing && v.frame.step > 1000; }));
    worker.send(event::Play{false});
    ASSERT_TRUE(see([](const RunView& v) { return !v.playing; }));
    EXPECT_GT(*view.steps_per_second, 0);
    EXPECT_GT(*view.evaluations_per_second, *view.steps_per_second);
    const Frame paused = view.frame;
    EXPECT_EQ(paused.positions, frame_after(view.description, paused.step).positions)
        << "the same bits as without a window";
    worker.send(event::Change{with_method(view.description, "verlet")});
    ASSERT_TRUE(see([](const RunView& v) { return v.description.method == "verlet"; }));
    EXPECT_EQ(*view.steps_per_second, 0) << "that of another method is not known yet";
}

TEST_F(WorkerTest, goes_on_with_another_method_and_restarts_with_another_model) {
    worker.send(event::Step{1});
    worker.send(event::Change{with_method(view.description, "verlet")});
    ASSERT_TRUE(see([](const RunView& v) { return v.description.method == "verlet" && v.frame.step == 1; }));
    const std::uint64_t run = view.run;
    worker.send(event::Change{with_model(view.description, "rope")});
    ASSERT_TRUE(see([](const RunView& v) { return v.description.model == "rope"; }));
    EXPECT_EQ(view.frame.step, 0u);
    EXPECT_GT(view.run, run);
}

TEST_F(WorkerTest, refuses_with_a_message_and_goes_on) {
    RunDescription wrong = view.description;
    wrong.dt = 0;
    worker.send(event::Change{wrong});
    ASSERT_TRUE(see([](const RunView& v) { return !v.error.empty(); }));
    EXPECT_THAT(view.error, testing::HasSubstr("dt must be"));
    EXPECT_EQ(view.description.dt, 0.1);
    worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 1; }));
    EXPECT_EQ(view.error, "");
}

TEST_F(WorkerTest, stops_where_the_run_diverges) {
    RunDescription large = view.description;
    large.dt = 2;
    worker.send(event::Change{large});
    worker.send(event::SetRate{{true, 1}});
    worker.send(event::Play{true});
    ASSERT_TRUE(see([](const RunView& v) { return v.divergence.has_value(); }));
    EXPECT_FALSE(view.playing);
    EXPECT_EQ(view.divergence->step, view.frame.step);
    for (const Vec3& p : view.frame.positions) EXPECT_TRUE(std::isfinite(p.x));
    worker.send(event::Restart{});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 0; }));
    EXPECT_FALSE(view.divergence);
}

TEST_F(WorkerTest, counts_what_it_refuses) {
    RunDescription wrong = view.description;
    wrong.dt = 0;
    for (std::uint64_t times = 1; times <= 2; ++times) {
        worker.send(event::Change{wrong});
        ASSERT_TRUE(see([=](const RunView& v) { return v.failures == times; }));
        EXPECT_THAT(view.error, testing::HasSubstr("dt must be"));
    }
}

TEST_F(WorkerTest, tracks_a_particle_with_its_exact_solution) {
    worker.send(event::Track{9});
    worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 1 && v.tracked; }));
    EXPECT_EQ(view.tracked->particle, 9u);
    ASSERT_TRUE(view.tracked->exact_displacement);
    EXPECT_NEAR(view.tracked->displacement.x, view.tracked->exact_displacement->x, 1e-6);  // rk4's error of one step
    worker.send(event::Track{1000});
    ASSERT_TRUE(see([](const RunView& v) { return !v.tracked; })) << "no such particle";
}

TEST_F(WorkerTest, shows_forces_when_they_are_asked_for) {
    EXPECT_TRUE(view.frame.forces.empty());
    worker.send(event::ShowForces{true});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.forces.size() == v.frame.positions.size(); }));
    worker.send(event::ShowForces{false});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.forces.empty(); }));
}

TEST_F(WorkerTest, pulls_a_particle) {
    worker.send(event::Do{Pull{5, {10, 1, 0}}});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.positions[5] == Vec3{10, 1, 0}; }));
    EXPECT_FALSE(view.has_exact);
}

TEST_F(WorkerTest, hands_over_whole_moments_that_grow_newer) {
    worker.send(event::SetRate{{true, 1}});
    worker.send(event::Play{true});
    Simulation simulation(view.description);
    for (std::uint64_t last = 0; last < 5000; last = view.frame.step) {
        ASSERT_TRUE(see([=](const RunView& v) { return v.frame.step > last; }));
        simulation.advance(view.frame.step - last);
        // Were a frame written to while it is looked at, or made of two moments, some number would differ.
        ASSERT_EQ(view.frame.positions, simulation.frame().positions) << view.frame.step;
        ASSERT_EQ(view.frame.velocities, simulation.frame().velocities) << view.frame.step;
        ASSERT_EQ(view.diagnostics.energy, simulation.diagnostics().energy) << view.frame.step;
        ASSERT_EQ(view.frame.time, simulation.time());
    }
}

TEST_F(WorkerTest, of_several_views_the_newest_is_taken) {
    for (int i = 0; i < 3; ++i) worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 3; }));
    EXPECT_EQ(view.frame.positions, frame_after(view.description, 3).positions);
    EXPECT_NE(view.frame.positions, frame_after(view.description, 2).positions);
    while (worker.take(session)) EXPECT_EQ(view.frame.step, 3u) << "an older one was kept";
}

/// Sees the ensemble of the moment that the view shows.
bool has_ensemble(const RunView& view) { return !view.frame.ensemble.empty(); }

/// Where the members of a run of this description are that nothing was done to.
EnsembleSpread reading_after(const RunDescription& description, const LiveEnsembleOptions& ensemble,
                             std::uint64_t steps) {
    Simulation simulation(description);
    simulation.advance(steps);
    const std::vector<SegmentBegin> segments{{0, description}};
    LiveEnsemble live_ensemble(ensemble.runs, [&](const RunDescription& run, std::size_t member) {
        return run_in_range(run, std::vector{range_of(ensemble, run)}, member, ensemble.runs);
    });
    live_ensemble.go_to(steps, segments);
    Frame frame = simulation.frame();
    return live_ensemble.observe(frame);
}

TEST_F(WorkerTest, has_a_ensemble_only_when_asked_for_one) {
    worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 1; }));
    EXPECT_FALSE(has_ensemble(view));
    const LiveEnsembleOptions ensemble{.runs = 5, .spread = "k", .width = 0.01};
    worker.send(event::ShowEnsemble{ensemble});
    ASSERT_TRUE(see(has_ensemble));
    EXPECT_EQ(view.ensemble, ensemble);
    EXPECT_EQ(view.frame.ensemble.size(), 5 * view.frame.positions.size());
    EXPECT_EQ(view.ensemble_spread, reading_after(view.description, ensemble, 1)) << "from the start of the run on";
    EXPECT_GT(view.ensemble_spread.largest, 0);
    worker.send(event::ShowEnsemble{{}});
    ASSERT_TRUE(see([](const RunView& v) { return v.ensemble.runs == 0; }));
    EXPECT_FALSE(has_ensemble(view));
}

TEST_F(WorkerTest, takes_the_ensemble_along_on_the_way_forth_and_back) {
    const LiveEnsembleOptions ensemble{.runs = 5, .spread = "k", .width = 0.01};
    worker.send(event::ShowEnsemble{ensemble});
    worker.send(event::SetRate{{true, 1}});
    worker.send(event::Play{true});
    ASSERT_TRUE(see([](const RunView& v) { return has_ensemble(v) && v.frame.step > 1000; }));
    worker.send(event::Play{false});
    ASSERT_TRUE(see([](const RunView& v) { return !v.playing && has_ensemble(v); }));
    const std::uint64_t end = view.frame.step;
    EXPECT_EQ(view.ensemble_spread, reading_after(view.description, ensemble, end));
    worker.send(event::Step{-1});
    ASSERT_TRUE(see([=](const RunView& v) { return v.frame.step == end - 1 && has_ensemble(v); }));
    EXPECT_EQ(view.ensemble_spread, reading_after(view.description, ensemble, end - 1));
    EXPECT_NE(view.ensemble_spread, reading_after(view.description, ensemble, end));
    worker.send(event::Restart{});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 0 && has_ensemble(v); }));
    EXPECT_EQ(view.ensemble_spread.largest, 0) << "k differs, the start does not";
}

TEST_F(WorkerTest, does_to_the_ensemble_what_is_done_to_the_run) {
    worker.send(event::ShowEnsemble{{.runs = 3, .spread = "v0", .width = 0}});
    for (int i = 0; i < 3; ++i) worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 3 && has_ensemble(v); }));
    worker.send(event::Change{with_method(view.description, "euler")});
    ASSERT_TRUE(see([](const RunView& v) { return v.description.method == "euler" && has_ensemble(v); }));
    worker.send(event::Step{1});
    worker.send(event::Do{Pull{5, {10, 1, 0}}});
    worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 5 && has_ensemble(v); }));
    EXPECT_EQ(view.ensemble_spread.largest, 0) << "runs that do not differ stay together";
    for (int i = 0; i < 3; ++i) worker.send(event::Step{-1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 2 && has_ensemble(v); }));
    EXPECT_EQ(view.ensemble_spread.largest, 0);
    worker.send(event::Change{with_model(view.description, "morse")});
    ASSERT_TRUE(see([](const RunView& v) { return v.description.model == "morse" && has_ensemble(v); }));
    EXPECT_EQ(view.frame.ensemble.size(), 3 * view.frame.positions.size());
}

TEST_F(WorkerTest, goes_on_without_a_ensemble_that_is_too_large) {
    worker.send(event::ShowEnsemble{{.runs = LiveEnsemble::most_particles}});
    ASSERT_TRUE(see([](const RunView& v) { return !v.error.empty(); }));
    EXPECT_THAT(view.error, testing::HasSubstr("too large"));
    EXPECT_EQ(view.ensemble.runs, 0u);
    worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 1; }));
}

TEST_F(WorkerTest, waits_for_companions_that_begin_later) {
    worker.send(event::SetRate{{true, 1}});
    worker.send(event::Play{true});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step > 100000; }));
    // So many steps of 256 members take far longer than it computes between two looks at the commands.
    worker.send(event::ShowEnsemble{{.runs = 256}});
    ASSERT_TRUE(see([](const RunView& v) { return v.ensemble.runs == 256; }));
    EXPECT_FALSE(has_ensemble(view)) << "answers while they are on their way";
    EXPECT_LT(view.ensemble_spread.step, view.frame.step);
    EXPECT_TRUE(view.playing);
    const std::uint64_t step = view.frame.step;
    worker.send(event::Track{3});
    ASSERT_TRUE(see([](const RunView& v) { return v.tracked && v.tracked->particle == 3; }));
    EXPECT_EQ(view.frame.step, step);
    worker.send(event::ShowEnsemble{{}});
    ASSERT_TRUE(see([=](const RunView& v) { return v.frame.step > step; })) << "and goes on playing";
}

TEST_F(WorkerTest, lives_on_where_memory_for_a_view_is_missing) {
    worker.send(event::ShowEnsemble{{.runs = 256}});
    ASSERT_TRUE(see(has_ensemble));
    {
        const NoLargerThan limit(16384);  // the places of 256 times 10 particles take more, whatever else there is less
        worker.send(event::Step{1});
        ASSERT_TRUE(see([](const RunView& v) { return !v.error.empty(); }));
    }
    EXPECT_EQ(view.error, "out of memory");
    EXPECT_EQ(view.ensemble.runs, 0u);
    EXPECT_FALSE(has_ensemble(view));
    EXPECT_EQ(view.frame.positions.size(), 10u);
    worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 2; }));
    EXPECT_EQ(view.error, "");
    EXPECT_EQ(view.frame.positions, frame_after(view.description, 2).positions);
}

TEST_F(WorkerTest, lives_on_where_memory_for_moments_to_come_back_to_is_missing) {
    worker.send(event::Change{run_of("chain", "rk4", Precision::double_, 0.1, {{"n", 1000}})});
    worker.send(event::SetRate{{true, 1}});
    worker.send(event::Play{true});
    // By now each of the views that are passed around has its memory.
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(see([](const RunView& v) { return v.frame.positions.size() == 1000; }));
    {
        const NoLargerThan limit(16384);  // 3 numbers for each of 1000 particles take more
        ASSERT_TRUE(see([](const RunView& v) { return !v.error.empty(); }));
    }
    EXPECT_FALSE(view.playing);
    worker.send(event::Restart{});
    worker.send(event::Step{1});
    ASSERT_TRUE(see([](const RunView& v) { return v.frame.step == 1; }));
    EXPECT_EQ(view.error, "");
}

// A mesh has moved 10^7 s only after some hours.
TEST(Worker, ends_in_the_middle_of_a_step) {
    Worker worker(run_of("mesh", "taylor", Precision::double_, 1e7));
    worker.send(event::Step{1});
}

TEST_F(WorkerTest, stops_while_playing) {
    worker.send(event::SetRate{{true, 1}});
    worker.send(event::Play{true});
    ASSERT_TRUE(see([](const RunView& v) { return v.playing; }));
}

}  // namespace
}  // namespace steplab::test
