#include "core/team.hpp"

#include "core/flush_subnormals.hpp"
#include "core/interruption.hpp"
#include "support/no_threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace steplab::test {
namespace {

TEST(RendezvousOf, fewer_members_than_expected_continues) {
    Rendezvous meeting(5);
    std::atomic<int> released = 0;
    {
        std::vector<std::jthread> others;
        others.reserve(2);
        for (int i = 0; i < 2; ++i) {
            others.emplace_back([&] {
                meeting.wait();
                ++released;
            });
        }
        meeting.expect(3);
        meeting.wait();
    }
    EXPECT_EQ(released, 2);
}

class TeamOf : public testing::TestWithParam<std::size_t> {};

TEST_P(TeamOf, does_every_piece_of_work_once) {
    Team team(GetParam());
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
        std::vector<std::atomic<int>> done(count);
        team.share(count, [&](std::size_t i) { ++done[i]; });
        for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
    }
}

TEST_P(TeamOf, throws_on_the_first_exception_and_begins_nothing_after_it) {
    Team team(GetParam());
    std::atomic<std::size_t> begun = 0;
    const auto fail = [&](std::size_t i) {
        ++begun;
        throw std::runtime_error(std::to_string(i));
    };
    EXPECT_THROW(team.share(1000, fail), std::runtime_error);
    EXPECT_LE(begun, GetParam());
    begun = 0;
    team.share(10, [&](std::size_t) { ++begun; });
    EXPECT_EQ(begun, 10u);  // the team still works
}

// Too many calls to complete: a member that continued after another's exception would never return.
TEST_P(TeamOf, ends_for_all_on_the_exception_of_one) {
    const auto first_fails = [](std::size_t i) {
        if (i == 0) throw std::runtime_error("enough");
    };
    EXPECT_THROW(Team(GetParam()).share(std::numeric_limits<std::size_t>::max() / 2, first_fails), std::runtime_error);
}

TEST_P(TeamOf, members_are_interrupted_with_the_thread_that_they_work_for) {
    std::atomic<bool> asked = true;
    std::atomic<int> interrupted = 0;
    const auto counts = [&](std::size_t) {
        try {
            check_interruption();
        } catch (const Interrupted&) {
            ++interrupted;
        }
    };
    Team team(GetParam());
    {
        const InterruptibleBy interruptible(asked);
        team.share(50, counts);
    }
    EXPECT_EQ(interrupted, 50);
    team.share(50, counts);
    EXPECT_EQ(interrupted, 50) << "nothing asks any more";
}

TEST_P(TeamOf, waits_at_the_barrier_for_all_members) {
    Team team(GetParam());
    std::atomic<std::size_t> here = 0;
    std::atomic<bool> early = false;
    team.run([&](std::size_t) {
        for (std::size_t round = 1; round <= 100; ++round) {
            ++here;
            team.meet();
            if (here != round * team.members()) early = true;
            team.meet();
        }
    });
    EXPECT_FALSE(early);
}

TEST_P(TeamOf, computes_in_the_mode_of_the_caller) {
    Team team(GetParam());
    const auto subnormals = [&] {
        std::atomic<std::size_t> nonzero = 0;
        team.run([&](std::size_t) {
            volatile double least = std::numeric_limits<double>::min();
            nonzero += least / 2 > 0 ? 1 : 0;
        });
        return nonzero.load();
    };
    EXPECT_EQ(subnormals(), team.members());
    {
        const FlushSubnormals flush;
        EXPECT_EQ(subnormals(), 0u);
    }
    EXPECT_EQ(subnormals(), team.members());
}

TEST(TeamWithoutThreads, does_all_the_work_by_itself) {
    const NoThreads none;
    Team team(5);
    EXPECT_EQ(team.members(), 1u);
    std::size_t done = 0;
    team.share(1000, [&](std::size_t) { ++done; });
    EXPECT_EQ(done, 1000u);
    team.run([&](std::size_t) { team.meet(); });
}

INSTANTIATE_TEST_SUITE_P(Sizes, TeamOf, testing::Values(1, 2, 5));

}  // namespace
}  // namespace steplab::test
