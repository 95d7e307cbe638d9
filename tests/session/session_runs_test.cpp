#include "core/error.hpp"
#include "core/number_text.hpp"
#include "session/session_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

/// Each follower stands where a run of its own stands that was taken to its step at that time.
void expect_equal_times(Session& session) {
    session.finish();
    for (const FollowerRun& follower : session.followers()) {
        const double time = session.run().time(), dt = follower.run().dt();
        EXPECT_LE(follower.run().time(), time + 1e-6 * dt);
        EXPECT_GT(follower.run().time() + dt, time);
    }
}

TEST(Session, shows_runs_of_different_dt_at_the_same_time) {
    Session session(chain("rk4"));
    session.handle(event::Step{7});
    session.handle(event::AddRun{with(chain("verlet"), "dt", 0.03)});
    session.handle(event::AddRun{with(chain("euler", Precision::float_), "dt", 0.25)});
    expect_equal_times(session);
    session.advance(20);
    expect_equal_times(session);
    EXPECT_EQ(session.followers()[0].run().step(), 90u);
    EXPECT_EQ(session.followers()[1].run().step(), 10u);
    Simulation alone(with(chain("verlet"), "dt", 0.03));
    alone.advance(90);
    EXPECT_EQ(session.followers()[0].run().hash(), alone.hash()) << "the same bits as alone";
    go_to(session, 3);
    expect_equal_times(session);
    EXPECT_EQ(session.followers()[0].run().step(), 10u);
}

TEST(Session, magnifies_what_is_drawn_of_every_run_and_nothing_that_is_computed) {
    Session session(chain("rk4")), usual(chain("rk4"));
    session.handle(event::AddRun{chain("verlet")});
    session.handle(event::Magnify{100});
    for (Session* const each : {&session, &usual}) {
        each->handle(event::Step{3});
        each->finish();
    }
    SessionView view, expected;
    session.observe(view);
    usual.observe(expected);
    EXPECT_EQ(view.leading.frame.magnified, 100);
    EXPECT_EQ(view.followers.at(0).frame.magnified, 100);
    EXPECT_EQ(expected.leading.frame.magnified, 1);
    EXPECT_EQ(view.leading.frame.positions, expected.leading.frame.positions);
    EXPECT_EQ(session.run().hash(), usual.run().hash());
    session.handle(event::Undo{});
    session.observe(view);
    EXPECT_EQ(view.leading.frame.magnified, 100) << "it is nothing to undo";
}

TEST(Session, does_to_all_runs_what_is_done_to_the_scene) {
    Session session(chain("rk4"));
    session.handle(event::AddRun{chain("verlet")});
    session.handle(event::Step{10});
    session.finish();
    session.handle(event::Do{Pull{5, {10, 1, 0}}});
    session.handle(event::Change{with(with(chain("rk4"), "k", 2), "dt", 0.05)});
    session.handle(event::Step{10});
    session.finish();
    Simulation alone(chain("verlet"));
    alone.advance(10);
    alone.act(Pull{5, {10, 1, 0}});
    alone.change(with(chain("verlet"), "k", 2));
    alone.advance(5);
    EXPECT_EQ(session.followers()[0].run().hash(), alone.hash()) << "k is the scene's, dt the run's own";
    session.handle(event::Step{-15});
    session.handle(event::Step{2});
    session.finish();
    EXPECT_EQ(session.followers()[0].run().step(), 7u);
    go_to(session, 20);
    EXPECT_EQ(session.followers()[0].run().hash(), alone.hash()) << "also after having gone back";
}

TEST(Session, adds_a_run_to_which_all_that_was_done_happens_too) {
    Session session(chain("rk4"));
    session.handle(event::Step{10});
    session.handle(event::Do{Kick{5, {0.1, 0, 0}}});
    session.handle(event::Step{10});
    session.handle(event::AddRun{chain("rk4")});
    session.finish();
    EXPECT_EQ(session.followers()[0].run().hash(), session.run().hash());
    session.handle(event::Change{with(chain("rk4"), "k", 2)});
    session.handle(event::Step{10});
    session.handle(event::AddRun{session.run().description()});
    session.finish();
    EXPECT_EQ(session.followers()[1].run().hash(), session.run().hash()) << "it begins with the k of the start";
    session.handle(event::Undo{});
    session.handle(event::Undo{});
    session.handle(event::Step{10});
    session.finish();
    EXPECT_EQ(session.followers().size(), 1u);
    EXPECT_EQ(session.followers()[0].run().hash(), session.run().hash());
}

TEST(Session, takes_back_what_is_done_to_its_runs_in_the_order_in_which_it_was_done) {
    Session session(chain("rk4"));
    session.handle(event::AddRun{with(chain("verlet"), "dt", 0.05)});
    session.handle(event::Step{10});
    session.handle(event::Do{Kick{5, {0.1, 0, 0}}});
    session.handle(event::Step{10});
    session.handle(event::Bookmark{"here"});
    const auto all = [&] {
        session.finish();
        std::vector<std::string> runs{session.run().description().method + session.run().hash()};
        for (const FollowerRun& each : session.followers())
            runs.push_back(each.description().method + number_text(each.description().dt) + each.run().hash());
        return runs;
    };
    const Event events[] = {event::AddRun{chain("euler-forward")},
                            event::ChangeRun{2, with(chain("verlet"), "dt", 0.02)},
                            event::EqualCost{true},
                            event::Lead{1},
                            event::RemoveRun{2},
                            event::RemoveRun{0},
                            event::Do{Kick{3, {0, 0.1, 0}}},
                            event::Restart{}};
    std::vector<std::vector<std::string>> before{all()};
    for (const Event& event : events) {
        session.handle(event);
        before.push_back(all());
    }
    for (std::size_t i = std::size(events); i-- > 0;) {
        session.handle(event::Undo{});
        EXPECT_EQ(all(), before[i]) << "of event " << i;
    }
    SessionView view;
    session.observe(view);
    EXPECT_EQ(view.line.bookmarks.size(), 1u) << "another leading run had none";
    for (std::size_t i = 0; i < std::size(events); ++i) {
        session.handle(event::Redo{});
        EXPECT_EQ(all(), before[i + 1]) << "of event " << i;
    }
}

TEST(Session, keeps_the_branches_of_a_run_that_led_for_undo) {
    Session session(chain("rk4"));
    session.handle(event::Step{20});
    session.handle(event::Step{-10});
    session.handle(event::Do{Kick{5, {0.1, 0, 0}}});
    session.handle(event::AddRun{chain("verlet")});
    SessionView view;
    session.handle(event::Lead{1});
    session.observe(view);
    EXPECT_TRUE(view.line.branches.empty()) << "they are those of the other run";
    session.handle(event::Undo{});
    session.observe(view);
    EXPECT_EQ(view.line.branches.size(), 1u);
    EXPECT_EQ(session.followers().size(), 1u);
}

TEST(Session, lets_the_run_that_led_begin_again_as_it_began) {
    Session session(chain("rk4"));
    session.handle(event::AddRun{chain("verlet")});
    session.handle(event::Step{10});
    session.handle(event::Change{with(chain("rk4"), "k", 2)});
    session.handle(event::Step{10});
    session.handle(
        event::Change{with_alterations(session.run().description(), std::vector<Alteration>{{5, std::nullopt, 3.0}})});
    session.handle(event::Step{10});
    const std::string led = session.run().hash();
    session.handle(event::Lead{1});
    session.finish();
    EXPECT_EQ(session.followers()[0].run().hash(), led);
}

TEST(Session, another_run_takes_the_lead_at_the_same_time) {
    Session session(chain("rk4"));
    session.handle(event::AddRun{with(chain("verlet"), "dt", 0.05)});
    session.handle(event::Step{10});
    session.finish();
    const std::string follower = session.followers()[0].run().hash(), leading = session.run().hash();
    session.handle(event::Lead{1});
    session.finish();
    EXPECT_EQ(session.run().hash(), follower);
    EXPECT_EQ(session.followers()[0].run().hash(), leading);
    session.handle(event::RemoveRun{0});
    EXPECT_EQ(session.run().description().method, "rk4");
    EXPECT_EQ(session.run().hash(), leading);
    EXPECT_TRUE(session.followers().empty());
}

TEST(Session, a_run_that_diverges_stays_behind_and_the_others_go_on) {
    Session session(chain("rk4"));
    session.handle(event::AddRun{with(chain("rk4"), "dt", 2)});
    session.handle(event::Step{6000});
    session.finish();
    EXPECT_TRUE(session.followers()[0].run().divergence());
    EXPECT_EQ(session.run().step(), 6000u);
    EXPECT_FALSE(session.is_behind());
    SessionView view;
    session.observe(view);
    EXPECT_TRUE(view.followers[0].divergence);
    EXPECT_FALSE(view.leading.divergence);
}

TEST(Session, a_run_that_diverged_goes_on_with_another_dt) {
    Session session(with(chain("rk4"), "dt", 2));
    session.handle(event::Step{6000});
    ASSERT_TRUE(session.run().divergence());
    const std::uint64_t last_good = session.run().step();
    session.handle(event::Change{with(chain("rk4"), "dt", 0.1)});
    EXPECT_FALSE(session.run().divergence());
    EXPECT_EQ(session.run().description().dt, 0.1);
    session.handle(event::Step{10});
    EXPECT_EQ(session.run().step(), last_good + 10);
    const std::string there = session.run().hash();
    go_to(session, 0);
    go_to(session, last_good + 10);
    EXPECT_EQ(session.run().hash(), there);
    session.handle(event::Undo{});
    EXPECT_EQ(session.run().description().dt, 2);
    EXPECT_EQ(session.run().step(), last_good);
}

TEST(Session, of_which_a_run_cannot_follow_stays_as_it_is) {
    RunDescription stiff = with(with(chain("rk4"), "k", 1e39), "dt", 1e-22);  // no float holds this k
    Session session(stiff);
    session.handle(event::AddRun{with_method(stiff, "verlet")});
    session.handle(event::Step{2});
    RunDescription soft = with(stiff, "k", 1);
    session.handle(event::Change{soft});
    soft.precision = Precision::float_;
    session.handle(event::Change{soft});
    session.handle(event::Step{2});
    session.finish();
    const std::string before = session.run().hash();
    EXPECT_THROW(session.handle(event::Lead{1}), UsageError) << "it would begin in float with the k of the start";
    session.handle(event::Step{1});
    session.handle(event::Step{-1});
    session.finish();
    EXPECT_EQ(session.run().hash(), before);
    EXPECT_EQ(session.followers().size(), 1u);
}

TEST(Session, keeps_the_cost_equal_when_a_change_is_taken_back) {
    Session session(chain("rk4"));
    session.handle(event::AddRun{chain("euler")});
    session.handle(event::EqualCost{true});
    const double dt = session.followers()[0].description().dt;
    session.handle(event::Step{5});
    session.handle(event::Change{with(chain("rk4"), "dt", 0.2)});
    EXPECT_EQ(session.followers()[0].description().dt, 2 * dt);
    session.handle(event::Undo{});
    EXPECT_EQ(session.followers()[0].description().dt, dt);
    session.handle(event::Redo{});
    EXPECT_EQ(session.followers()[0].description().dt, 2 * dt);
}

TEST(Session, that_begins_with_another_run_alone_comes_back_as_one) {
    Session session(chain());
    session.handle(event::AddRun{with_method(chain(), "rk4")});
    session.handle(event::EqualCost{true});
    session.advance(12);
    const std::string hash = session.run().hash();
    session.handle(event::Begin{run_of("rope", "rk4", Precision::double_, 0.01)});
    EXPECT_EQ(session.run().description().model, "rope");
    EXPECT_EQ(session.run().step(), 0u);
    EXPECT_TRUE(session.followers().empty());
    session.handle(event::Undo{});
    EXPECT_EQ(session.run().hash(), hash);
    ASSERT_EQ(session.followers().size(), 1u);
    session.handle(event::Redo{});
    EXPECT_EQ(session.run().description().model, "rope");
    EXPECT_TRUE(session.followers().empty());
}

// Unlike a change of the method, it begins at step 0 also where the scene is the same.
TEST(Session, that_begins_with_the_same_scene_is_at_its_start) {
    Session session(chain());
    session.advance(5);
    session.handle(event::Begin{with_method(chain(), "rk4")});
    EXPECT_EQ(session.run().step(), 0u);
    EXPECT_EQ(session.run().description().method, "rk4");
}

TEST(Session, takes_back_one_change_of_two_with_another_event_between_them) {
    Session session(chain("rk4"));
    session.handle(event::Step{5});
    session.handle(event::Change{with(chain("rk4"), "dt", 0.2)});
    session.handle(event::AddRun{chain("verlet")});
    session.handle(event::Change{with(chain("rk4"), "dt", 0.3)});
    session.handle(event::Undo{});
    EXPECT_EQ(session.run().description().dt, 0.2);
    EXPECT_EQ(session.followers().size(), 1u);
    session.handle(event::Undo{});
    EXPECT_TRUE(session.followers().empty());
    session.handle(event::Undo{});
    EXPECT_EQ(session.run().description().dt, 0.1);
}

}  // namespace
}  // namespace steplab::test
