#include "app/cli/progress.hpp"

#include <gtest/gtest.h>

namespace steplab {
namespace {

TEST(Progress, names_the_part_done_and_the_time_left) {
    EXPECT_EQ(progress_text(0.5, 10), "[###############---------------]  50 %  10 s left");
    EXPECT_EQ(progress_line("steplab report", 0.25, 60), "steplab report: 25 %, 3 min 00 s left\n");
    EXPECT_EQ(progress_line("steplab report", 1, 60), "steplab report: 100 %, 0 s left\n");
}

TEST(Progress, names_no_time_before_anything_is_done) {
    EXPECT_EQ(progress_text(0, 10), "[------------------------------]   0 %");
    EXPECT_EQ(progress_line("steplab advise", 0, 10), "steplab advise: 0 %\n");
}

TEST(Progress, writes_nothing_at_once) {
    testing::internal::CaptureStderr();
    {
        Progress hidden(10, false), lines(10, false, "steplab report");
        hidden.at(5), lines.at(5), lines.stage("a run");
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace steplab
