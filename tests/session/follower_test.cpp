#include "session/follower_run.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace steplab::test {
namespace {

constexpr auto never = [] { return false; };

RunDescription followed_chain(double dt) { return run_of("chain", "rk4", Precision::double_, dt); }

void step_to(TimeLine& line, std::uint64_t step) {
    line.turn_to(step);
    line.advance(step - std::min(step, line.step()));
}

/// What a run beside the leading one is where it never was elsewhere.
std::string hash_beside(const TimeLine& leading, const RunDescription& description) {
    FollowerRun fresh(description, TimeLine::usual_bytes);
    fresh.follow(leading, never);
    return fresh.run().hash();
}

// Its steps are longer: at one of them it stands before what is done and behind it.
TEST(FollowerRun, gone_back_has_nothing_that_is_done_later) {
    TimeLine leading(followed_chain(0.01));
    FollowerRun follower(followed_chain(0.1), TimeLine::usual_bytes);
    leading.advance(25);
    leading.act(Pull{5, {4.5, 0.5, 0}});
    leading.advance(10);
    follower.follow(leading, never);
    EXPECT_TRUE(follower.is_beside(leading));
    for (const std::uint64_t step : {22u, 27u, 21u, 35u, 3u}) {
        step_to(leading, step);
        follower.follow(leading, never);
        EXPECT_TRUE(follower.is_beside(leading));
        EXPECT_EQ(follower.run().hash(), hash_beside(leading, followed_chain(0.1))) << "step " << step;
    }
}

// That it diverged is found some steps later: gone back to between, it has not diverged yet.
TEST(FollowerRun, of_a_run_that_diverged_is_the_same_from_both_sides) {
    TimeLine leading(followed_chain(0.1));
    FollowerRun follower(followed_chain(2), TimeLine::usual_bytes);
    leading.advance(20 * 300);
    follower.follow(leading, never);
    ASSERT_TRUE(follower.run().divergence());
    const std::uint64_t last = follower.run().step();
    for (const std::uint64_t step : {last - 1, last + 1, last + 5, last - 2, last}) {
        step_to(leading, 20 * step);
        follower.follow(leading, never);
        EXPECT_TRUE(follower.is_beside(leading));
        EXPECT_EQ(follower.run().hash(), hash_beside(leading, followed_chain(2))) << "step " << step;
    }
}

TEST(FollowerRun, goes_back_to_where_the_leading_run_went_another_way_and_no_further) {
    TimeLine leading(followed_chain(0.1));
    FollowerRun follower(followed_chain(0.01), TimeLine::usual_bytes);
    leading.advance(1000);
    leading.act(Kick{5, {0.1, 0, 0}});
    for (int i = 0; i < 10; ++i) {
        leading.advance(100);
        follower.follow(leading, never);
    }
    int pieces = 0;
    const auto count = [&] { return ++pieces, false; };
    step_to(leading, 1990);
    leading.act(Kick{5, {0, 0.1, 0}});
    leading.advance(20);
    follower.follow(leading, count);
    EXPECT_EQ(follower.run().hash(), hash_beside(leading, followed_chain(0.01)));
    leading.undo();
    leading.undo();
    leading.advance(20);
    follower.follow(leading, count);
    EXPECT_EQ(follower.run().hash(), hash_beside(leading, followed_chain(0.01)));
    EXPECT_LT(pieces, 40) << "of 64 steps; from the start there would be over 300";
}

}  // namespace
}  // namespace steplab::test
