#include "session/session.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "session/compared.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

RunDescription chain(std::string_view method = "verlet", Precision precision = Precision::double_) {
    return run_of("chain", method, precision, 0.1);
}

RunDescription with(RunDescription run, std::string_view name, double value) {
    if (name == "dt") {
        run.dt = value;
    } else {
        run.scene.set(name, value);
    }
    return run;
}

void go_to(Session& session, std::uint64_t step) {
    session.handle(event::Seek{step});
    session.finish();
}

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

TEST(Session, plays_backwards_with_all_its_runs_until_the_start) {
    Session session(chain("rk4"));
    session.handle(event::AddRun{with(chain("verlet", Precision::float_), "dt", 0.25)});
    std::vector<std::string> hashes{session.run().hash()}, beside{session.followers()[0].run().hash()};
    for (int i = 0; i < 200; ++i) {
        session.handle(event::Step{1});
        session.finish();
        hashes.push_back(session.run().hash());
        beside.push_back(session.followers()[0].run().hash());
    }
    session.handle(event::Play{true, true});
    for (std::uint64_t step = 200; step > 0;) {
        session.play_on(7);
        session.finish();
        step -= std::min<std::uint64_t>(step, 7);
        ASSERT_EQ(session.run().step(), step);
        EXPECT_EQ(session.playing(), step > 0);
        EXPECT_EQ(session.run().hash(), hashes[step]) << "step " << step;
        EXPECT_EQ(session.followers()[0].run().hash(), beside[step]) << "step " << step;
    }
    session.handle(event::Play{true, true});
    EXPECT_FALSE(session.playing()) << "there is nothing before the start";
}

TEST(Session, plays_a_loop_from_either_end_to_the_other) {
    for (const bool backwards : {false, true}) {
        Session session(chain("rk4"));
        session.handle(event::Step{100});
        session.handle(event::Loop{StepRange{20, 50}});
        session.handle(event::Play{true, backwards});
        std::uint64_t ends = 0;
        for (int i = 0; i < 60; ++i) {
            session.play_on(8);
            session.finish();
            EXPECT_TRUE(session.playing());
            const std::uint64_t step = session.run().step();
            if (backwards ? step == 50 : step == 20) ++ends;
            EXPECT_TRUE(ends == 0 || (20 <= step && step <= 50)) << step;
        }
        EXPECT_GE(ends, 9u);
        session.handle(event::Loop{});
        for (int i = 0; i < 20; ++i) session.play_on(8);
        EXPECT_EQ(session.run().step() == 0, backwards);
        EXPECT_EQ(session.run().step() > 100, !backwards);
    }
}

TEST(Session, plays_a_loop_in_which_the_run_diverges_to_where_it_does) {
    Session session(with(chain("rk4"), "dt", 2));
    session.handle(event::Step{6000});
    ASSERT_TRUE(session.run().divergence());
    const std::uint64_t last = session.run().step();
    session.handle(event::Loop{StepRange{last / 2, last + 1000}});
    session.handle(event::Play{true});
    std::uint64_t first = last, furthest = 0;
    for (int i = 0; i < 300; ++i) {
        session.play_on(8);
        session.finish();
        ASSERT_TRUE(session.playing());
        first = std::min(first, session.run().step());
        furthest = std::max(furthest, session.run().step());
    }
    EXPECT_EQ(first, last / 2);
    EXPECT_GT(furthest, last / 2);
    EXPECT_THROW(session.handle(event::Loop{StepRange{5, 5}}), UsageError);
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
