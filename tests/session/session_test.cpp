#include "session/session_test.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace steplab::test {
namespace {

TEST(Session, does_what_events_say_in_their_order) {
    Session session(chain());
    session.handle(event::Step{3});
    session.handle(event::Change{with(chain(), "dt", 0.2)});
    session.handle(event::Step{2});
    session.handle(event::Do{Kick{5, {0.1, 0, 0}}});
    session.handle(event::Step{1});
    Simulation alone(chain());
    alone.advance(3);
    alone.change(with(chain(), "dt", 0.2));
    alone.advance(2);
    alone.act(Kick{5, {0.1, 0, 0}});
    alone.advance(1);
    EXPECT_EQ(session.run().step(), 6u);
    EXPECT_EQ(session.run().hash(), alone.hash());
    EXPECT_EQ(session.run().time(), alone.time());
}

TEST(Session, seeks_forth_and_back_and_never_forgets_what_lies_ahead) {
    Session session(chain());
    session.handle(event::Step{50});
    const std::string there = session.run().hash();
    go_to(session, 10);
    EXPECT_EQ(session.run().step(), 10u);
    EXPECT_EQ(session.line().reached(), 50u);
    session.handle(event::SeekTime{5});
    session.finish();
    EXPECT_EQ(session.run().step(), 50u);
    EXPECT_EQ(session.run().hash(), there);
    session.handle(event::Step{-60});
    EXPECT_EQ(session.run().step(), 0u);
}

// Its card was closed for good: at the last good step nothing told that the run had ended there.
TEST(Session, that_is_taken_to_the_end_of_a_run_that_diverged_finds_that_again) {
    RunDescription description = chain("euler");
    description.dt = 2.5;
    Session session(description);
    session.handle(event::Step{1000});
    ASSERT_TRUE(session.line().is_over());
    const std::uint64_t end = session.run().step();
    const std::string message = session.run().divergence()->message, there = session.run().hash();
    for (const std::uint64_t from : {std::uint64_t{0}, end / 2, end - 1}) {
        go_to(session, from);
        EXPECT_FALSE(session.line().is_over()) << from;
        go_to(session, end);
        ASSERT_TRUE(session.line().is_over()) << from;
        EXPECT_EQ(session.run().divergence()->message, message);
        EXPECT_EQ(session.run().hash(), there);
        EXPECT_EQ(session.line().reached(), end);
    }
    go_to(session, end - 1);
    session.handle(event::Change{with(description, "dt", 0.1)});
    session.handle(event::Step{1});
    EXPECT_FALSE(session.line().is_over()) << "another way";
    go_to(session, 0);
    go_to(session, end);
    EXPECT_FALSE(session.line().is_over());
    EXPECT_EQ(session.run().step(), end);
}

TEST(Session, undoes_and_does_again_everything_the_start_of_another_scene_too) {
    Session session(chain());
    session.handle(event::Step{10});
    const std::string at_ten = session.run().hash();
    session.handle(event::Change{with(chain(), "k", 2)});
    session.handle(event::Step{5});
    session.handle(event::Do{Pull{5, {10, 1, 0}}});
    session.handle(event::Step{5});
    const std::string at_twenty = session.run().hash();
    session.handle(event::Change{describe("mesh")});
    session.handle(event::Step{4});
    EXPECT_EQ(session.run().description().model, "mesh");
    SessionView view;
    session.handle(event::Undo{});
    session.observe(view);
    EXPECT_EQ(view.leading.description.model, "chain");
    EXPECT_EQ(session.run().hash(), at_twenty) << "no run is lost by a wrong click";
    session.handle(event::Undo{});
    EXPECT_EQ(session.run().step(), 15u) << "before the pull";
    session.handle(event::Undo{});
    EXPECT_EQ(session.run().hash(), at_ten);
    EXPECT_EQ(session.run().description().scene["k"], 1);
    session.observe(view);
    EXPECT_FALSE(view.line.can_undo);
    EXPECT_TRUE(view.line.can_redo);
    for (int i = 0; i < 3; ++i) session.handle(event::Redo{});
    EXPECT_EQ(session.run().description().model, "mesh");
    EXPECT_EQ(session.run().step(), 4u);
    session.handle(event::Undo{});
    go_to(session, 20);
    EXPECT_EQ(session.run().hash(), at_twenty);
}

TEST(Session, restarts_with_the_present_settings_and_can_be_taken_back) {
    Session session(chain());
    session.handle(event::Step{10});
    session.handle(event::Change{with(chain(), "dt", 0.2)});
    session.handle(event::Step{10});
    const std::string before = session.run().hash();
    session.handle(event::Restart{});
    EXPECT_EQ(session.run().step(), 0u);
    EXPECT_EQ(session.run().description().dt, 0.2);
    session.handle(event::Undo{});
    EXPECT_EQ(session.run().hash(), before);
}

TEST(Session, keeps_the_ways_that_it_left) {
    Session session(chain());
    session.handle(event::Step{30});
    const std::string plain = session.run().hash();
    go_to(session, 10);
    session.handle(event::Do{Kick{5, {0.1, 0, 0}}});
    session.handle(event::Step{20});
    const std::string kicked = session.run().hash();
    SessionView view;
    session.observe(view);
    ASSERT_EQ(view.line.branches.size(), 1u);
    EXPECT_NEAR(view.line.branches[0].from, 1, 1e-12);
    EXPECT_NEAR(view.line.branches[0].to, 3, 1e-12);
    ASSERT_EQ(view.line.changes.size(), 1u);
    EXPECT_EQ(view.line.changes[0].text, "kick of particle 5");
    session.handle(event::TakeBranch{0});
    EXPECT_EQ(session.run().step(), 10u);
    go_to(session, 30);
    EXPECT_EQ(session.run().hash(), plain);
    session.handle(event::TakeBranch{0});
    go_to(session, 30);
    EXPECT_EQ(session.run().hash(), kicked);
}

TEST(Session, refuses_and_stays_as_it_is) {
    Session session(chain());
    session.handle(event::Step{5});
    const std::string before = session.run().hash();
    const auto refuses = [&](const Event& event) {
        EXPECT_THROW(session.handle(event), UsageError);
        EXPECT_EQ(session.run().hash(), before);
    };
    refuses(event::Change{with(chain(), "dt", 0)});
    refuses(event::AddRun{describe("mesh")});
    refuses(event::AddRun{with(chain(), "n", 11)});
    refuses(event::ChangeRun{1, chain()});
    refuses(event::RemoveRun{0});
    refuses(event::RemoveRun{1});
    refuses(event::Lead{1});
    refuses(event::TakeBranch{0});
    for (int i = 0; i < 3; ++i) session.handle(event::AddRun{chain("rk4")});
    refuses(event::AddRun{chain("rk4")});
    EXPECT_EQ(session.followers().size(), 3u);
}

TEST(Session, time_runs_back_without_drag) {
    Session session(chain("velocity-verlet"));
    session.handle(event::Step{100});
    session.handle(event::Do{TurnRound{}});
    session.handle(event::Step{100});
    // what 200 steps round off; positions are near 20
    EXPECT_LT(distance(session.run().frame(), Simulation(chain()).frame()), 1e-12);
    Session with_drag(with(chain("velocity-verlet"), "c", 0.1));
    with_drag.handle(event::Step{100});
    with_drag.handle(event::Do{TurnRound{}});
    with_drag.handle(event::Step{100});
    EXPECT_GT(distance(with_drag.run().frame(), Simulation(chain()).frame()), 1e-3);
}

TEST(Session, marks_moments) {
    Session session(chain());
    session.handle(event::Step{10});
    session.handle(event::Bookmark{"here"});
    go_to(session, 3);
    session.handle(event::Bookmark{"there"});
    SessionView view;
    session.observe(view);
    ASSERT_EQ(view.line.bookmarks.size(), 2u);
    EXPECT_EQ(view.line.bookmarks[0].text, "there");
    EXPECT_EQ(view.line.bookmarks[1].step, 10u);
    session.handle(event::Bookmark{""});
    session.observe(view);
    EXPECT_EQ(view.line.bookmarks.size(), 1u);
}

TEST(Overtakes, what_is_dragged_and_nothing_else) {
    EXPECT_TRUE(overtakes(event::Change{chain()}, event::Change{chain()}));
    EXPECT_TRUE(overtakes(event::Do{Pull{5, {}}}, event::Do{Pull{5, {}}}));
    EXPECT_FALSE(overtakes(event::Do{Pull{5, {}}}, event::Do{Pull{6, {}}}));
    EXPECT_FALSE(overtakes(event::Do{Kick{5, {}}}, event::Do{Kick{5, {}}}));
    EXPECT_FALSE(overtakes(event::Step{1}, event::Step{1}));
    EXPECT_FALSE(overtakes(event::Change{chain()}, event::Step{1}));
    EXPECT_FALSE(overtakes(event::Step{1}, event::Change{chain()}));
    EXPECT_TRUE(overtakes(event::Seek{1}, event::Seek{2}));
    EXPECT_FALSE(overtakes(event::ChangeRun{1, chain()}, event::ChangeRun{2, chain()}));
    EXPECT_FALSE(overtakes(event::Undo{}, event::Undo{}));
}

}  // namespace
}  // namespace steplab::test
