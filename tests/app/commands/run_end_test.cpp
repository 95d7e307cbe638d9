#include "app/program.hpp"
#include "app/tables.hpp"
#include "io/files.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace steplab {
namespace {

using testing::HasSubstr;

TEST(Run, methods_of_own_steps_end_at_the_time_asked_for) {
    for (const test::MethodCase& c : test::methods_where(
             [](const test::MethodCase& c) { return chooses_its_steps(describe("chain", c.info->id)); })) {
        const Outcome outcome =
            run_program({"run", "--model", "oscillator", "--method", c.id(), "--precision",
                         std::string(id(c.precision)), "--until", "1", "--dt", "0.3", "--out", "-", "--every", "1"});
        EXPECT_EQ(outcome.code, 0);
        EXPECT_THAT(outcome.err, testing::Not(HasSubstr("note"))) << c;
        const CsvTable csv = table(outcome.out);
        EXPECT_EQ(csv.rows.back()[0], "4");
        EXPECT_EQ(csv.rows.back()[1], "1");
        EXPECT_NEAR(number(csv.rows.back()[3]), std::sin(1.0), 1e-5) << c;  // float
    }
    const Outcome outcome = run_program({"run", "--until", "1", "--dt", "0.3", "--summary", "-"});
    const std::string note = "4 steps of dt = 0.3 s end at t = 1.2 s, not at 1 s";
    EXPECT_THAT(outcome.err, HasSubstr(note));
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["notes"], nlohmann::json::array({note}));
}

TEST(Run, ensembles_and_pictures_that_end_later_say_so) {
    const TemporaryFolder folder;
    const std::vector<std::string> ensemble{"run", "--ensemble", "3",   "--spread",  "k=1:2", "--until",
                                            "1",   "--dt",       "0.3", "--summary", "-"};
    const std::vector<std::string> picture{"snapshot", "--until", "1", "--dt", "0.3", "--out", folder.file("a.png")};
    for (const auto& words : {ensemble, picture})
        EXPECT_THAT(run_program(words).err, HasSubstr("4 steps of dt = 0.3 s end at t = 1.2 s, not at 1 s"));
}

TEST(Run, energy_errors_of_scenes_with_drag_hold_its_work) {
    const auto cells = [](const char* method) {
        const std::vector<std::string> words{"run",  "--model", "rope", "--method", method, "--dt",
                                             "0.01", "--steps", "100",  "--series", "-"};
        return table(run_program(words).out).rows.back();
    };
    // of 45 J that drag takes: an error of fourth order, and of the hundredth step
    EXPECT_LT(std::abs(number(cells("rk4")[5])), 1e-3);
    EXPECT_LT(std::abs(number(cells("taylor")[5])), 1e-7);
    EXPECT_EQ(cells("rkn-12-10")[5], "");  // it has no velocities within its steps
}

// A potential far narrower than the distance between two numbers near the place where the bullet meets it.
TEST(Run, a_run_whose_method_meets_no_tolerance_says_where_and_of_what) {
    const Outcome outcome =
        run_program({"run", "--model", "morse", "--set", "edge=1", "--set", "k=1e20", "--set", "cutoff=2", "--method",
                     "dopri5", "--dt", "20", "--steps", "1", "--summary", "-"});
    EXPECT_EQ(outcome.code, 4);
    const auto summary = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(summary.at("status"), "stopped");
    EXPECT_EQ(summary.at("steps"), 0);
    EXPECT_EQ(summary.at("stopped_step"), 1);
    EXPECT_FALSE(summary.contains("diverged_step"));
    const std::string reason = summary.at("reason");
    for (const char* word : {"meets its tolerance", "t = ", "step of ", "particles 0 and 1"})
        EXPECT_THAT(reason, HasSubstr(word));
    EXPECT_THAT(reason, testing::Not(HasSubstr("dt")));
    EXPECT_THAT(outcome.err, HasSubstr("steplab run: " + reason + "\n"));
}

TEST(Run, a_run_that_diverged_has_not_stopped) {
    const Outcome outcome =
        run_program({"run", "--model", "chain", "--method", "rk4", "--dt", "2", "--steps", "1000", "--summary", "-"});
    EXPECT_EQ(outcome.code, 4);
    const auto summary = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(summary.at("status"), "diverged");
    EXPECT_TRUE(summary.contains("diverged_step"));
    EXPECT_FALSE(summary.contains("stopped_step"));
}

}  // namespace
}  // namespace steplab
