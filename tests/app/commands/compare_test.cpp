#include "app/program.hpp"
#include "app/tables.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace steplab {
namespace {

using testing::HasSubstr;

constexpr const char* header = "time,run,error,rms_error,energy_error,momentum_error,reference_error,evaluations";

TEST(CompareCommand, writes_a_row_for_each_sample_and_run) {
    const Outcome outcome = run_program({"compare", "--model", "chain", "--until", "6", "--samples", "3", "--run",
                                         "method=rk4,dt=0.1", "--run", "method=verlet,dt=0.1,precision=float"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("run 0: method=rk4,dt=0.1,precision=double"));
    EXPECT_THAT(outcome.err, HasSubstr("run 1: method=verlet,dt=0.1,precision=float"));
    const std::vector<std::string> lines = split(outcome.out, '\n');
    ASSERT_EQ(lines.size(), 9u) << outcome.out;
    EXPECT_EQ(lines[0], header);
    EXPECT_THAT(lines[1], testing::StartsWith("0,0,0,0,0,,0,"));
    EXPECT_THAT(lines[2], testing::StartsWith("0,1,"));
    EXPECT_THAT(lines[7], testing::StartsWith("6,0,"));
    const std::vector<std::string> end = split(lines[7], ',');
    ASSERT_EQ(end.size(), 8u);
    EXPECT_GT(std::stod(end[2]), 1e-7);
    EXPECT_LT(std::stod(end[2]), 1e-3);
    EXPECT_EQ(end[5], "") << "a particle is fixed";
    EXPECT_EQ(end[7], "240");
}

TEST(CompareCommand, adds_the_runs_of_a_scene_file) {
    const std::string file = testing::TempDir() + "compared.toml";
    std::ofstream(file) << "steplab = 1\n[[particles]]\nfixed = true\n[[particles]]\nposition = [1, 0, 0]\n"
                           "velocity = [1, 0, 0]\n[[springs]]\npairs = [[0, 1]]\nk = 1\nlength = 1\n"
                           "[run]\nmethod = \"rk4\"\ndt = 0.1\nuntil = 1\ncompare = [\"method=euler\"]\n";
    const Outcome own = run_program({"compare", "--scene", file, "--samples", "1"});
    EXPECT_EQ(own.code, 0) << own.err;
    EXPECT_THAT(own.err, HasSubstr("run 0: method=rk4"));
    EXPECT_THAT(own.err, HasSubstr("run 1: method=euler"));
    const Outcome more = run_program({"compare", "--scene", file, "--samples", "1", "--run", "dt=0.2"});
    EXPECT_THAT(more.err, HasSubstr("run 0: method=rk4,dt=0.2"));
    EXPECT_THAT(more.err, HasSubstr("run 1: method=euler"));
}

TEST(CompareCommand, ends_the_rows_of_a_run_that_diverges) {
    const Outcome outcome = run_program({"compare", "--model", "chain", "--until", "600", "--samples", "6", "--run",
                                         "method=rk4,dt=2", "--run", "method=rk4,dt=0.1"});
    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(outcome.err, HasSubstr("run 0: "));
    EXPECT_THAT(outcome.out, HasSubstr("\n600,1,"));
    EXPECT_THAT(outcome.out, testing::Not(HasSubstr("\n600,0,")));
}

TEST(CompareCommand, a_run_that_diverges_does_not_look_best_in_the_table) {
    const std::vector<std::string> diverging{"compare", "--model",         "chain", "--until",           "600",
                                             "--run",   "method=rk4,dt=2", "--run", "method=rk4,dt=0.1", "--samples"};
    const auto row_of = [&](const std::string& samples) {
        std::vector<std::string> words = diverging;
        words.push_back(samples);
        const Outcome outcome = run_program(words);
        for (const std::string& line : split(outcome.err, '\n')) {
            if (line.starts_with("  0    ")) return line;
        }
        ADD_FAILURE() << outcome.err;
        return std::string();
    };
    const std::string before_any = row_of("6"), after_one = row_of("300");
    // step 4 is the last good one, and the samples of the first are 100 s apart, those of the other 2 s
    EXPECT_THAT(before_any, testing::ContainsRegex("  diverged at t = 8 s +16  ")) << "it has no energy error";
    EXPECT_THAT(after_one, testing::ContainsRegex("  diverged at t = 8 s \\(13\\.[0-9]+ before\\)  "));
}

TEST(CompareCommand, refuses_what_it_cannot_compare) {
    const std::vector<std::string> base{"compare", "--model", "chain", "--until", "1"};
    const auto refuses = [&](std::vector<std::string> more, const char* message) {
        std::vector<std::string> words = base;
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(message));
        EXPECT_EQ(outcome.out, "");
    };
    refuses({}, "give two to four --run");
    refuses({"--run", "dt=0.1"}, "give two to four --run");
    refuses({"--run", "dt=1", "--run", "dt=2", "--run", "dt=3", "--run", "dt=4", "--run", "dt=5"}, "5 runs");
    refuses({"--run", "dt=0.1", "--run", "method=rk5"}, "--run method=rk5: ");
    refuses({"--run", "dt=0.1", "--run", "dt=0.2", "--samples", "0"}, "--samples");
    refuses({"--run", "dt=0.1", "--run", "dt=0.2", "--until", "-1"}, "until");
}

}  // namespace
}  // namespace steplab
