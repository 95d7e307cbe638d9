// What a session keeps of what was left, and what it forgets with it.

#include "core/error.hpp"
#include "session/replay_test.hpp"
#include "session/session_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace steplab::test {
namespace {

SessionView view_of(const Session& session) {
    SessionView view;
    session.observe(view);
    return view;
}

TEST(Session, keeps_the_newest_ways_that_it_left) {
    Session session(chain());
    for (std::size_t i = 0; i < Session::most_branches + 4; ++i) {
        session.handle(event::Step{10});
        session.handle(event::Step{-5});
        session.handle(event::Do{Kick{5, {0.1, 0, 0}}});
    }
    const auto branches = view_of(session).line.branches;
    ASSERT_EQ(branches.size(), Session::most_branches);
    // the first one kept was left after four others, each of 5 steps of 0.1 s; sums of tenths
    EXPECT_NEAR(branches.front().from, 2.5, 1e-9);
}

TEST(Session, takes_back_as_many_restarts_as_it_keeps) {
    Session session(chain());
    for (std::size_t i = 0; i < Session::most_left + 3; ++i) {
        session.handle(event::Step{static_cast<std::int64_t>(i) + 1});
        session.handle(event::Restart{});
    }
    std::size_t taken_back = 0;
    for (; view_of(session).line.can_undo; ++taken_back) session.handle(event::Undo{});
    EXPECT_EQ(taken_back, Session::most_left);
    EXPECT_EQ(session.run().step(), 4u) << "the oldest one that is kept is the fourth of seven";
}

TEST(Session, that_takes_another_way_has_nothing_to_do_again) {
    Session session(chain());
    session.handle(event::Step{10});
    session.handle(event::Step{-5});
    session.handle(event::Do{Kick{5, {0.1, 0, 0}}});
    session.handle(event::Step{5});
    session.handle(event::Do{Kick{6, {0.1, 0, 0}}});
    session.handle(event::Undo{});
    ASSERT_TRUE(view_of(session).line.can_redo);
    session.handle(event::TakeBranch{0});
    EXPECT_FALSE(view_of(session).line.can_redo);
    session.handle(event::Undo{});
    EXPECT_EQ(view_of(session).line.changes.size(), 1u) << "the way of the first kick";
}

TEST(Session, does_nothing_again_once_something_else_was_done) {
    Session session(chain());
    session.handle(event::Step{5});
    session.handle(event::Change{with(chain(), "dt", 0.2)});
    session.handle(event::Change{with(with(chain(), "dt", 0.2), "k", 2)});
    session.handle(event::Undo{});
    ASSERT_TRUE(view_of(session).line.can_redo);
    session.handle(event::Change{with(chain(), "dt", 0.3)});  // takes the place of the first one: nothing more to undo
    EXPECT_FALSE(view_of(session).line.can_redo);
    session.handle(event::Undo{});
    EXPECT_EQ(session.run().description().dt, 0.1);
}

TEST(Session, has_nothing_to_undo_of_what_it_refused) {
    Session session(chain());
    EXPECT_THROW(session.handle(event::AddRun{with(chain(), "n", 11)}), UsageError);
    EXPECT_THROW(session.handle(event::ChangeRun{1, chain()}), UsageError);
    EXPECT_FALSE(view_of(session).line.can_undo);
}

TEST(Session, that_begins_with_another_run_has_no_ensemble_and_no_equal_cost) {
    Session session(chain());
    session.handle(event::AddRun{chain("rk4")});
    session.handle(event::EqualCost{true});
    session.handle(event::ShowEnsemble{{.runs = 3}});
    session.handle(event::Begin{chain("rk4")});
    EXPECT_FALSE(view_of(session).equal_cost);
    EXPECT_EQ(view_of(session).leading.ensemble.runs, 0u);
}

TEST(Session, restarts_all_runs_with_what_was_changed_of_the_scene) {
    Session session(chain());
    session.handle(event::AddRun{with(chain("rk4"), "m", 3)});
    session.handle(event::Step{10});
    session.handle(event::Change{with(chain(), "k", 2)});
    session.handle(event::Change{with(with(chain(), "k", 2), "dt", 0.05)});
    session.finish();
    EXPECT_EQ(session.followers()[0].run().description().scene["m"], 3) << "its own";
    EXPECT_EQ(session.followers()[0].run().description().scene["k"], 2);
    session.handle(event::Restart{});
    EXPECT_EQ(session.followers()[0].description().scene["k"], 2);
    EXPECT_EQ(session.followers()[0].description().scene["m"], 3);
    EXPECT_EQ(session.followers()[0].description().dt, 0.1);
}

TEST(Session, runs_beside_each_other_are_of_one_scene) {
    const RunDescription one = of_scene_file();
    const std::string other = replaced(scene_text, "softening = 0.1", "softening = 0.2");
    Session session(one);
    EXPECT_THROW(
        session.handle(event::AddRun{describe(scene_from(
            {{.name = "", .content = other}, {.name = "a.xyz", .content = particles_text}}, "folder/a.toml"))}),
        UsageError);
    session.handle(event::AddRun{with_method(one, "rk4")});
    EXPECT_EQ(session.followers().size(), 1u);
}

TEST(Session, goes_back_with_a_run_that_diverged) {
    Session session(chain("rk4"));
    session.handle(event::AddRun{with(chain("rk4"), "dt", 2)});
    session.handle(event::Step{6000});
    session.finish();
    const std::uint64_t last = session.followers()[0].run().step();
    ASSERT_TRUE(session.followers()[0].run().divergence());
    for (const std::uint64_t step : {last + 10, last + 1, last, last - 1, std::uint64_t{2}, last + 7}) {
        session.handle(event::Seek{20 * step});
        session.finish();
        Simulation alone(with(chain("rk4"), "dt", 2));
        alone.advance(std::min(step, last));
        EXPECT_EQ(session.followers()[0].run().divergence().has_value(), step >= last)
            << step << ": its energy there is impossible";
        EXPECT_EQ(session.followers()[0].run().hash(), alone.hash()) << step;
    }
}

TEST(Session, does_nothing_to_a_run_that_diverged) {
    Session session(chain("rk4"));
    session.handle(event::AddRun{with(chain("rk4"), "dt", 2)});
    session.handle(event::Step{6000});
    session.finish();
    ASSERT_TRUE(session.followers()[0].run().divergence());
    const std::string end = session.followers()[0].run().hash();
    session.handle(event::Do{Kick{5, {0.1, 0, 0}}});
    session.handle(event::Step{2000});
    session.finish();
    EXPECT_EQ(session.followers()[0].run().hash(), end);
}

// No float holds this k.
TEST(Session, refuses_what_a_run_beside_the_leading_one_cannot_have) {
    Session session(with(chain("rk4"), "dt", 1e-22));
    session.handle(event::AddRun{with(chain("rk4", Precision::float_), "dt", 1e-22)});
    session.handle(event::AddRun{with(chain("verlet"), "dt", 1e-22)});
    session.handle(event::Step{2});
    session.finish();
    EXPECT_THROW(session.handle(event::Change{with(session.run().description(), "k", 1e39)}), UsageError);
    EXPECT_EQ(view_of(session).line.changes.size(), 0u);
    EXPECT_EQ(session.followers().size(), 2u);
    session.handle(event::RemoveRun{1});
    session.handle(event::Change{with(session.run().description(), "k", 1e39)});
    session.finish();
    EXPECT_EQ(session.followers()[0].run().description().scene["k"], 1e39);
}

TEST(Session, leaves_the_other_runs_where_they_are_when_one_is_taken_back) {
    Session session(chain("rk4"));
    session.handle(event::AddRun{chain("euler")});
    session.handle(event::Step{40});
    session.finish();
    session.handle(event::AddRun{chain()});
    session.handle(event::Undo{});
    ASSERT_EQ(session.followers().size(), 1u);
    EXPECT_EQ(session.followers()[0].run().step(), 40u);
}

TEST(Session, leaves_a_run_where_it_is_if_its_cost_stays_the_same) {
    Session session(chain("rk4"));
    session.handle(event::AddRun{chain("euler")});
    session.handle(event::EqualCost{true});
    session.handle(event::Step{40});
    session.finish();
    const std::uint64_t step = session.followers()[0].run().step();
    session.handle(event::Change{with(chain("rk4"), "k", 2)});
    EXPECT_EQ(session.followers()[0].run().step(), step);
}

TEST(Session, gives_the_run_that_leads_the_memory_of_one_that_leads) {
    const std::size_t one = Simulation(chain()).save().bytes();
    Session session(chain(), 400 * one);
    session.handle(event::AddRun{chain()});
    session.handle(event::Lead{1});
    for (int i = 0; i < 1000; ++i) {
        session.handle(event::Step{16});
        session.keep_moment();
    }
    EXPECT_GT(session.line().bytes(), 150 * one) << "a run beside it may keep 100";
    EXPECT_LE(session.line().bytes(), 400 * one);
}

TEST(Session, compares_a_run_of_three_hundred_particles_and_no_more) {
    const auto rope = [](double n) { return Session(run_of("rope", "rk4", Precision::double_, 0.01, {{"n", n}})); };
    EXPECT_TRUE(rope(300).wants_errors());
    EXPECT_FALSE(rope(301).wants_errors());
}

}  // namespace
}  // namespace steplab::test
