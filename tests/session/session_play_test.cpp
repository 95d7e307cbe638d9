#include "core/error.hpp"
#include "session/replayed.hpp"
#include "session/session_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

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
            EXPECT_LE(session.play_on(8), 8u) << "the way to the other end takes no time of the playback";
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
    EXPECT_TRUE(session.playing()) << "from where it ended, too";
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
    session.handle(event::Loop{StepRange{last / 2, last + 1000}});
    session.handle(event::Seek{last / 2 + 3});
    session.handle(event::Play{true, true});
    for (int i = 0; i < 300; ++i) {
        session.play_on(8);
        session.finish();
        ASSERT_TRUE(session.playing()) << "backwards too";
    }
}

TEST(Session, stops_playing_backwards_where_something_is_done) {
    for (const Event& event : {Event(event::Do{Kick{5, {0.1, 0, 0}}}), Event(event::Change{with(chain(), "k", 2)})}) {
        Session session(chain());
        session.handle(event::Step{50});
        session.handle(event::Play{true, true});
        session.play_on(10);
        session.handle(event);
        EXPECT_FALSE(session.playing());
        EXPECT_EQ(session.run().step(), 40u);
    }
}

// A branch is left where the run had got farther, also in a loop.
TEST(Session, in_a_loop_is_recorded_as_it_was) {
    Session session(chain());
    session.record();
    session.handle(event::Step{60});
    session.handle(event::Loop{StepRange{0, 100}});
    session.handle(event::Play{true});
    const auto play_to = [&](std::uint64_t step) {
        do {
            session.play_on(step > session.run().step() ? step - session.run().step() : 100);
        } while (session.run().step() != step);
    };
    play_to(99);
    play_to(50);
    session.handle(event::Do{Kick{5, {0.1, 0, 0}}});
    play_to(99);
    play_to(70);
    session.handle(event::Do{Kick{5, {0, 0.1, 0}}});
    session.handle(event::TakeBranch{1});
    EXPECT_EQ(replayed(*session.recorded()), "the same");
}

}  // namespace
}  // namespace steplab::test
