#include "session/share.hpp"

#include <gtest/gtest.h>

namespace steplab::test {
namespace {

using std::chrono::milliseconds;

TEST(Share, is_due_at_first_and_then_after_a_time_in_proportion) {
    Share share(0.05);
    const Share::Time begin{};
    EXPECT_TRUE(share.due(begin));
    share.took(begin, begin + milliseconds(10));
    // 10 of 200 ms are the part; the margin is what a number of nanoseconds in double is rounded by.
    EXPECT_FALSE(share.due(begin + milliseconds(199)));
    EXPECT_TRUE(share.due(begin + milliseconds(201)));
}

TEST(Share, waits_no_longer_than_it_may) {
    Share share(0.05, milliseconds(100));
    const Share::Time begin{};
    share.took(begin, begin + milliseconds(10));
    EXPECT_FALSE(share.due(begin + milliseconds(109)));
    EXPECT_TRUE(share.due(begin + milliseconds(110)));
}

TEST(Share, of_what_costs_nothing_is_always_due) {
    Share share(0.01);
    const Share::Time begin{};
    share.took(begin, begin);
    EXPECT_TRUE(share.due(begin));
}

}  // namespace
}  // namespace steplab::test
