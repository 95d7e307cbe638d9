#include "app/orderly_end.hpp"
#include "app/tables.hpp"
#include "io/files.hpp"
#include "session/session.hpp"
#include "session/session_file.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

// What the system does not grant: threads, memory, a folder for temporary files.

namespace steplab {
namespace {

using testing::HasSubstr;

std::ptrdiff_t files_in(const TemporaryFolder& folder) {
    return std::distance(std::filesystem::directory_iterator(folder.path()), {});
}

std::ptrdiff_t hidden_files_in(const TemporaryFolder& folder) {
    return std::count_if(std::filesystem::directory_iterator(folder.path()), {},
                         [](const auto& entry) { return entry.path().filename().string().starts_with('.'); });
}

std::string recorded_steps() {
    Session session(describe("chain", "verlet"));
    session.record();
    session.advance(20);
    session.handle(event::Do{Pull{3, {2.5, 0.25, 0}}});
    session.advance(20);
    return session_text(*session.recorded());
}

std::string hash_of(const Outcome& outcome) {
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out).at("hash");
}

TEST(WithoutThreads, runs_have_the_same_bits) {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& scene :
         {std::vector<std::string>{"--model", "chain", "--set", "n=300000", "--method", "velocity-verlet"},
          {"--model", "crystal", "--set", "edge=40", "--method", "velocity-verlet", "--dt", "0.01"}}) {
        std::vector<std::string> run{"run",       "--steps", "20",        "--every", "5",
                                     "--threads", "3",       "--summary", "-",       "--out"};
        run.insert(run.end(), {folder.file("rows.csv")});
        run.insert(run.end(), scene.begin(), scene.end());
        const std::string with = hash_of(run_program(run)), rows = text_of(folder.file("rows.csv"));
        EXPECT_EQ(hash_of(run_program(run, {.no_threads = true})), with);
        EXPECT_TRUE(text_of(folder.file("rows.csv")) == rows);
    }
    EXPECT_EQ(files_in(folder), 1);
}

TEST(WithoutThreads, every_command_does_its_work) {
    const TemporaryFolder folder;
    const std::string trajectory = folder.file("a.trajectory");
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"run", "--model", "chain", "--every", "1", "--out", trajectory},
          {"convert", trajectory, "--out", folder.file("a.csv")},
          {"run", "--model", "chain", "--ensemble", "100", "--spread", "k=1:2", "--steps", "10"},
          {"limits", "--model", "oscillator", "--method", "all"},
          {"hard-cases", "chaos"},
          {"advise", "--model", "oscillator", "--until", "3", "--error", "1e-3"},
          {"report", "--quick", "--model", "oscillator", "--time", "3", "--out", folder.file("report")}}) {
        const Outcome outcome = run_program(words, {.no_threads = true});
        EXPECT_EQ(outcome.code, 0) << words[0] << ": " << outcome.err;
        EXPECT_EQ(without_progress(outcome.err), "") << words[0];
    }
}

TEST(MemoryLimits, end_every_command_orderly) {
    const TemporaryFolder folder;
    const std::string rows = folder.file("a.csv"), trajectory = folder.file("a.trajectory");
    const std::string file = folder.file("whole.trajectory");
    ASSERT_EQ(run_program({"run", "--model", "mesh", "--set", "dim=60", "--out", file}).code, 0);
    const std::string crystal = folder.file("crystal.trajectory"), session = folder.file("a.session");
    ASSERT_EQ(run_program({"run", "--model", "crystal", "--steps", "2", "--dt", "0.01", "--out", crystal}).code, 0);
    put_text(session, recorded_steps());
    const unsigned long least = least_megabytes();
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"run", "--model", "mesh", "--set", "dim=100", "--steps", "2", "--out", rows},
          {"run", "--model", "crystal", "--set", "edge=20", "--steps", "2", "--dt", "0.01", "--out", trajectory},
          {"run", "--model", "chain", "--ensemble", "100", "--spread", "k=1:2", "--steps", "10", "--summary", rows},
          {"run", "--model", "chain", "--method", "gauss-16", "--steps", "2", "--series", rows},
          {"limits", "--model", "chain", "--method", "verlet"},
          {"convert", file, "--out", rows},
          {"export", "--model", "mesh", "--set", "dim=60", "--to", "scene", "--out", rows},
          {"compare", "--model", "oscillator", "--run", "dt=0.1", "--run", "dt=0.2", "--steps", "5", "--out", rows},
          {"advise", "--model", "oscillator", "--method", "rk4", "--until", "1", "--error", "1e-2"},
          {"observe", crystal, "--rdf", "--out", rows},
          {"replay", session},
          {"list"}}) {
        int done = 0;
        for (unsigned long megabytes = least; megabytes < least + 200; megabytes += megabytes < least + 20 ? 1 : 9) {
            for (const std::string& left : {rows, trajectory}) std::filesystem::remove(left);
            Outcome outcome = run_program(words, {.most_memory = megabytes << 20});
            outcome.err = std::regex_replace(outcome.err, std::regex("run [01]: .*\n"), "");  // what is compared
            expect_orderly_end(outcome, words[0] + " at " + std::to_string(megabytes) + " MB");
            EXPECT_EQ(hidden_files_in(folder), 0) << words[0];
            done += outcome.code == 0 ? 1 : 0;
        }
        EXPECT_GT(done, 0) << words[0];
    }
}

TEST(TemporaryFiles, are_not_needed_by_a_report) {
    const TemporaryFolder folder;
    const Outcome outcome =
        run_program({"report", "--quick", "--model", "oscillator", "--time", "3", "--method", "rk4", "--out", "out"},
                    {.folder = folder.path(), .environment = {"TMPDIR=/no/such/folder"}});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(files_in(folder), 1);
    std::set<std::string> written;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.file("out")))
        written.insert(entry.path().filename().string());
    EXPECT_EQ(written, (std::set<std::string>{"report.html", "speed_error.csv"})) << "nothing hidden is left";
}

}  // namespace
}  // namespace steplab
