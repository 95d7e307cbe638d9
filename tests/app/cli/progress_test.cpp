#include "app/cli/progress.hpp"

#include "support/extreme_doubles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>

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

TEST(Progress, is_some_part_of_its_bar_for_every_number) {
    for (const double fraction : special_doubles()) {
        const std::string text = progress_text(fraction, 10);
        const auto bar = std::count_if(text.begin(), text.end(), [](char c) { return c == '#' || c == '-'; });
        EXPECT_GE(bar, 30) << text;
    }
}

TEST(Progress, writes_nothing_at_once) {
    testing::internal::CaptureStderr();
    {
        Progress hidden(10, false), lines(10, false, "steplab report");
        hidden.at(5), lines.at(5), lines.stage("a run");
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Each at once, as if some seconds had passed.
TEST(Progress, writes_lines_where_there_is_no_terminal) {
    testing::internal::CaptureStderr();
    {
        Progress lines(10, false, "steplab report", std::chrono::milliseconds(0));
        Progress without_program(10, false, {}, std::chrono::milliseconds(0));
        lines.stage("computing the tables");
        lines.at(0);
        lines.at_part(0);
        without_program.at(5);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "steplab report: computing the tables\nsteplab report: 0 %\nsteplab report: 0 %\n");
}

}  // namespace
}  // namespace steplab
