// Changes that begin the runs again, sliders that are held, and what a run beside the leading one cannot have.

#include "core/error.hpp"
#include "session/session_test.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

TimeLineView line_of(const Session& session) {
    SessionView view;
    session.observe(view);
    return view.line;
}

Session three_runs() {
    Session session(chain("rk4"));
    session.handle(event::AddRun{with(chain("euler"), "dt", 0.05)});
    session.handle(event::AddRun{with(chain("midpoint"), "k", 2)});
    session.handle(event::Step{4});
    session.finish();
    return session;
}

void expect_three_runs(const Session& session, double speed) {
    ASSERT_EQ(session.followers().size(), 2u);
    const RunDescription &euler = session.followers()[0].run().description(),
                         &midpoint = session.followers()[1].run().description();
    EXPECT_EQ(euler.method, "euler");
    EXPECT_EQ(euler.dt, 0.05);
    EXPECT_EQ(midpoint.method, "midpoint");
    EXPECT_EQ(midpoint.scene["k"], 2);
    for (const RunDescription* const run : {&session.run().description(), &euler, &midpoint})
        EXPECT_EQ(run->scene["v0"], speed) << run->method;
}

TEST(Session, begins_all_its_runs_again_where_one_value_asks_for_it) {
    Session session = three_runs();
    const double before = session.run().description().scene["v0"];
    session.handle(event::Change{with(session.run().description(), "v0", 1)});
    EXPECT_EQ(session.run().step(), 0u);
    expect_three_runs(session, 1);
    session.handle(event::Undo{});
    expect_three_runs(session, before);
    session.handle(event::Redo{});
    expect_three_runs(session, 1);
    session.handle(event::Change{with(session.run().description(), "n", 12)});
    ASSERT_EQ(session.followers().size(), 2u);
    EXPECT_EQ(session.followers()[1].run().particles(), session.run().particles());
    session.handle(event::Change{run_of("mesh", "rk4", Precision::double_, 0.1)});
    EXPECT_EQ(session.followers().size(), 0u) << "runs of another scene do not go beside it";
}

TEST(Session, takes_a_slider_that_is_held_back_as_one) {
    for (const std::int64_t steps : {0, 3}) {  // it stands, or plays meanwhile
        Session session = three_runs();
        const double before = session.run().description().scene["v0"];
        for (int i = 0; i < 10; ++i) {
            session.handle(event::Change{with(session.run().description(), "v0", 1 + 0.1 * i), i > 0});
            session.handle(event::Step{steps});
        }
        expect_three_runs(session, 1.9);
        session.handle(event::Undo{});
        expect_three_runs(session, before);
        session.handle(event::Redo{});
        expect_three_runs(session, 1.9);
    }
}

TEST(Session, takes_a_held_slider_of_a_run_that_goes_on_back_as_one) {
    Session session = three_runs();
    const RunDescription before = session.run().description();
    session.handle(event::Do{Kick{5, {0.1, 0, 0}}});
    for (int i = 0; i < 10; ++i) {
        session.handle(event::Change{with(session.run().description(), "dt", 0.1 + 0.01 * (i + 1)), i > 0});
        session.handle(event::Step{3});
    }
    session.finish();
    const std::string there = session.run().hash();
    const std::uint64_t step = session.run().step();
    session.handle(event::Undo{});
    EXPECT_EQ(session.run().description(), before);
    EXPECT_EQ(line_of(session).changes.size(), 1u) << "the kick before it is another thing";
    session.handle(event::Redo{});
    go_to(session, step);
    EXPECT_EQ(session.run().hash(), there);
    session.handle(event::Change{with(session.run().description(), "dt", 0.3)});
    session.handle(event::Undo{});
    EXPECT_EQ(session.run().hash(), there) << "another drag is another thing";
}

TEST(Session, takes_back_that_it_went_over_to_another_way) {
    Session session = three_runs();
    session.handle(event::Step{36});
    go_to(session, 10);
    session.handle(event::Do{TurnRound{}});
    session.handle(event::Step{5});
    session.finish();
    const std::string turned = session.run().hash();
    ASSERT_EQ(line_of(session).branches.size(), 1u);
    session.handle(event::TakeBranch{0});
    EXPECT_EQ(line_of(session).changes.size(), 0u);
    session.handle(event::Undo{});
    EXPECT_EQ(session.followers().size(), 2u) << "a run that was added is not the last thing done";
    EXPECT_EQ(line_of(session).changes.size(), 1u);
    go_to(session, 15);
    EXPECT_EQ(session.run().hash(), turned);
    session.handle(event::Redo{});
    EXPECT_EQ(line_of(session).changes.size(), 0u);
    EXPECT_EQ(line_of(session).branches.size(), 1u);
    session.handle(event::Undo{});
    session.handle(event::Undo{});
    EXPECT_EQ(line_of(session).changes.size(), 0u) << "and then the turn before it";
    EXPECT_EQ(session.followers().size(), 2u);
    session.handle(event::Undo{});
    EXPECT_EQ(session.followers().size(), 1u);
}

TEST(Session, refuses_an_alteration_that_a_run_beside_cannot_have) {
    Session session(chain("rk4"));
    session.handle(event::AddRun{chain("verlet-2008")});
    session.handle(event::Step{3});
    const std::vector<Alteration> fixed{{.particle = 5, .fixed = true, .mass = {}}};
    const RunDescription altered = with_alterations(session.run().description(), fixed);
    EXPECT_THROW(session.handle(event::Change{altered}), UsageError);
    session.finish();
    ASSERT_EQ(session.followers().size(), 1u);
    session.handle(event::RemoveRun{1});
    session.handle(event::Change{altered});
    EXPECT_THROW(session.handle(event::AddRun{chain("verlet-2008")}), UsageError)
        << "it could not go where this one is";
    session.handle(event::Undo{});
    session.handle(event::AddRun{chain("verlet-2008")});
    session.finish();
    EXPECT_EQ(session.followers().size(), 1u);
}

// Found when it is shown, not only after a stretch of steps: at 2 s its energy has grown for 15 steps, tenfold and more
// in each.
TEST(Session, ends_a_run_that_diverges_where_it_ends_alone) {
    Session session(run_of("rope", "rk4", Precision::double_, 0.01));
    session.handle(event::AddRun{run_of("rope", "euler-forward", Precision::double_, 0.05)});
    Simulation alone(run_of("rope", "euler-forward", Precision::double_, 0.05));
    alone.advance(2000);
    ASSERT_TRUE(alone.divergence());
    for (int i = 0; i < 40; ++i) {
        session.handle(event::Step{5});
        session.finish();
    }
    EXPECT_TRUE(session.followers()[0].run().divergence());
    EXPECT_EQ(session.followers()[0].run().hash(), alone.hash());
    go_to(session, 50);
    EXPECT_FALSE(session.followers()[0].run().divergence());
    go_to(session, 200);
    EXPECT_EQ(session.followers()[0].run().hash(), alone.hash());
}

}  // namespace
}  // namespace steplab::test
