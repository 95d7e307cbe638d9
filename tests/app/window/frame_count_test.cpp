// The numbers by which frame times of the window are measured.
#include "app/window/frame_count.hpp"

#include <gtest/gtest.h>

namespace steplab::test {
namespace {

using std::chrono::milliseconds;

TEST(FrameCount, is_told_once_a_second_while_the_window_is_drawn) {
    const FrameCount::Time begin{std::chrono::hours(1)};
    FrameCount count;
    EXPECT_FALSE(count.news(begin)) << "nothing was drawn";
    count.drew_frame();
    EXPECT_EQ(count.news(begin), "1 0");
    for (int i = 0; i < 3; ++i) count.drew_frame();
    count.took_picture();
    EXPECT_FALSE(count.news(begin + milliseconds(999)));
    EXPECT_EQ(count.news(begin + milliseconds(1000)), "4 1");
    EXPECT_FALSE(count.news(begin + milliseconds(5000))) << "a window at rest";
    count.drew_frame();
    EXPECT_EQ(count.news(begin + milliseconds(5001)), "5 1");
}

}  // namespace
}  // namespace steplab::test
