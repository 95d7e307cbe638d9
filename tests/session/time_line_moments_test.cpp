// What a time line keeps to come back to, and what it forgets.

#include "session/changed_run.hpp"
#include "session/same_way.hpp"
#include "session/time_line.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

RunDescription kept_chain(double dt = 0.1) { return run_of("chain", "rk4", Precision::double_, dt); }

void stand_at(TimeLine& line, std::uint64_t step) {
    line.turn_to(step);
    line.advance(step - line.step());
}

/// The last step of which a moment is kept, up to this one.
std::uint64_t last_kept(const TimeLine& line, std::uint64_t step) {
    std::uint64_t last = 0;
    for (const ReplayedRun::Moment& moment : line.kept_moments()) {
        if (moment.snapshot.step() <= step) last = std::max(last, moment.snapshot.step());
    }
    return last;
}

TEST(TimeLine, keeps_the_moment_before_a_change_however_it_came_there) {
    TimeLine line(kept_chain());
    line.advance(1003);
    ASSERT_EQ(last_kept(line, 1003), 0u);
    line.act(Kick{5, {0.1, 0, 0}});
    const auto kept = line.kept_moments();
    EXPECT_TRUE(std::any_of(kept.begin(), kept.end(), [](const ReplayedRun::Moment& moment) {
        return moment.snapshot.step() == 1003 && moment.taken == 1;
    })) << "what is taken back at once is not computed from the start";
}

TEST(TimeLine, keeps_moments_near_where_it_went_back_to) {
    TimeLine line(kept_chain());
    line.advance(4000);  // at once: no moment on the way
    ASSERT_EQ(last_kept(line, 4000), 0u);
    line.step_back(1);
    EXPECT_EQ(line.step(), 3999u);
    EXPECT_GE(last_kept(line, 3998), 3999u - 2 * 8) << "the next steps back compute some 8 steps, not thousands";
    EXPECT_LT(line.kept_moments().size(), 16u) << "one for each halving of 4000 steps";
}

TEST(TimeLine, counts_no_memory_of_moments_that_it_left) {
    TimeLine line(kept_chain());
    line.advance(20);
    const std::size_t before = line.bytes();
    for (int i = 0; i < 20; ++i) {
        line.act(Kick{5, {0.1, 0, 0}});
        line.undo();
    }
    const std::size_t one = Simulation(kept_chain()).save().bytes();
    EXPECT_LE(line.bytes(), before + 2 * one) << "that before the kick is kept";
}

// The first moment after each change is kept as long as there is memory for two, and none beyond that.
TEST(TimeLine, keeps_to_its_memory_however_often_something_is_done) {
    const std::size_t one = Simulation(kept_chain()).save().bytes();
    TimeLine line(kept_chain(), 6 * one);
    for (int i = 0; i < 40; ++i) {
        line.advance(20);
        line.act(Kick{5, {0.01, 0, 0}});
        EXPECT_LE(line.bytes(), 6 * one);
    }
    const std::string end = line.run().hash();
    stand_at(line, 0);
    stand_at(line, 800);
    EXPECT_EQ(line.run().hash(), end);
}

TEST(TimeLine, keeps_the_moment_behind_a_change_when_others_grow_sparse) {
    const std::size_t one = Simulation(kept_chain()).save().bytes();
    TimeLine line(kept_chain(), 20 * one);
    line.advance(1003);
    line.act(Kick{5, {0.1, 0, 0}});
    for (int i = 0; i < 200; ++i) line.advance(100), line.keep_moment();
    const auto kept = line.kept_moments();
    EXPECT_LE(kept.size(), 20u);
    EXPECT_TRUE(std::any_of(kept.begin(), kept.end(), [](const ReplayedRun::Moment& moment) {
        return moment.snapshot.step() == 1003 && moment.taken == 2;
    }));
}

TEST(TimeLine, keeps_some_thousand_moments_at_most) {
    TimeLine line(kept_chain());
    for (int i = 0; i < 9000; ++i) line.advance(16), line.keep_moment();
    EXPECT_LE(line.kept_moments().size(), 4096u);
    EXPECT_GT(line.kept_moments().size(), 2048u);
}

TEST(TimeLine, that_gave_its_memory_back_keeps_moments_as_at_first) {
    const std::size_t one = Simulation(kept_chain()).save().bytes();
    TimeLine line(kept_chain(), 20 * one);
    for (int i = 0; i < 1000; ++i) line.advance(16), line.keep_moment();
    line.forget_moments();
    EXPECT_EQ(line.bytes(), 0u);
    for (int i = 0; i < 10; ++i) line.advance(16), line.keep_moment();
    EXPECT_EQ(line.kept_moments().size(), 10u);
    line.allow(4 * one);
    EXPECT_LE(line.bytes(), 4 * one) << "at once";
}

TEST(TimeLine, of_which_changes_ahead_are_forgotten_stays_where_it_is) {
    TimeLine line(kept_chain());
    line.advance(20);
    line.act(Kick{5, {0.1, 0, 0}});
    line.advance(20);
    stand_at(line, 5);
    line.keep_changes(1);
    EXPECT_EQ(line.step(), 5u);
    EXPECT_EQ(line.changes().size(), 1u);
    EXPECT_EQ(line.reached(), 20u);
}

TEST(TimeLine, forgets_what_its_steps_cost_where_they_become_others) {
    TimeLine line(kept_chain());
    EXPECT_FALSE(line.cost());
    line.advance(100);
    ASSERT_TRUE(line.cost());
    line.act(Kick{5, {0.1, 0, 0}});
    EXPECT_TRUE(line.cost()) << "steps after a kick cost the same";
    line.change(with(line.run().description(), "dt", 0.05));
    EXPECT_FALSE(line.cost());
}

// Its energy swings about the bound: behind the last good step there are steps at which it is possible again.
TEST(TimeLine, keeps_nothing_beyond_the_end_of_a_run_that_diverged) {
    const RunDescription run = run_of("chain", "velocity-verlet", Precision::double_, 0.9874);
    Simulation alone(run);
    alone.advance(1000);
    ASSERT_TRUE(alone.divergence());
    TimeLine line(run);
    line.advance(alone.step() + 1);
    while (!line.run().is_plausible()) line.advance(1);
    const std::uint64_t beyond = line.step();
    ASSERT_FALSE(line.is_over()) << "it is not known yet";
    line.keep_moment();
    ASSERT_EQ(last_kept(line, beyond), beyond);
    line.advance(1000);
    ASSERT_EQ(line.step(), alone.step());
    line.turn_to(beyond);
    EXPECT_EQ(line.step(), alone.step());
}

// Told to go on, a run that has ended is not known to have got any farther.
TEST(TimeLine, ended_where_it_was_found_on_the_way) {
    TimeLine line(kept_chain(2));
    line.advance(3000);
    ASSERT_TRUE(line.is_over());
    EXPECT_TRUE(line.ended_beyond(2999));
    for (const std::uint64_t more : {0u, 5000u}) {
        line.advance(more);
        EXPECT_TRUE(line.ended_beyond(2999));
        EXPECT_FALSE(line.ended_beyond(3000));
    }
}

TEST(SameWay, ends_with_the_first_step_at_which_either_is_another) {
    const std::vector<SegmentBegin> plain{{0, kept_chain()}}, early{{0, kept_chain()}, {5, kept_chain(0.2)}},
        late{{0, kept_chain()}, {10, kept_chain(0.2)}};
    EXPECT_EQ(first_difference(early, late), 5u);
    EXPECT_EQ(first_difference(late, early), 5u);
    EXPECT_EQ(first_difference(plain, late), 10u);
    EXPECT_EQ(first_difference(late, late), std::nullopt);
}

}  // namespace
}  // namespace steplab::test
