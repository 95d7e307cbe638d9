#include "app/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

namespace steplab {
namespace {

using testing::HasSubstr;

/// What is wrong is said before a window is opened, hence without a display.
void expect_refused(std::vector<std::string> words, const std::vector<std::string>& more, const char* played) {
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run_program(words);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(more.front() + " goes beside a run"));
    EXPECT_THAT(outcome.err, HasSubstr(played));
    EXPECT_THAT(outcome.err, HasSubstr("--model, --scene"));
}

TEST(played_alone, a_trajectory_in_the_window_refuses_runs_and_ensembles) {
    const std::string file = testing::TempDir() + "played-alone.trajectory";
    ASSERT_EQ(run_program({"run", "--model", "chain", "--steps", "2", "--out", file}).code, 0);
    const std::vector<std::string> view{"view", "--trajectory", file};
    expect_refused(view, {"--run", "method=rk4", "--run", "method=euler"}, "the trajectory '");
    expect_refused(view, {"--ensemble", "4", "--spread", "k=1:2"}, "the trajectory '");
}

TEST(played_alone, a_lesson_refuses_runs) {
    expect_refused({"view", "--lesson", "one-step"}, {"--run", "method=rk4", "--run", "method=euler"},
                   "the lesson 'one-step'");
}

TEST(played_alone, a_session_refuses_runs_and_ensembles) {
    const std::string file = testing::TempDir() + "played-alone.session";
    std::ofstream(file) << "steplab-session = 1\n[start]\nmodel = \"oscillator\"\nparameters = {}\nmethod = \"rk4\"\n"
                           "precision = \"double\"\ndt = 0.1\n";
    expect_refused({"view", "--session", file}, {"--run", "method=rk4", "--run", "method=euler"}, "the session '");
    expect_refused({"view", "--session", file}, {"--ensemble", "4", "--spread", "k=1:2"}, "the session '");
}

}  // namespace
}  // namespace steplab
