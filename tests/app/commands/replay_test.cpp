#include "app/folder_watch.hpp"
#include "app/program.hpp"
#include "io/files.hpp"
#include "io/temporary_folder.hpp"
#include "session/session.hpp"
#include "session/session_file.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <fstream>
#include <string>

namespace steplab {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

/// Two pulls, a change and steps between them.
std::string recorded() {
    Session session(describe("chain", "verlet"));
    session.record();
    session.advance(20);
    session.handle(event::Do{Pull{3, {2.5, 0.25, 0}}});
    RunDescription faster = session.run().description();
    faster.dt = 0.05;
    session.advance(20);
    session.handle(event::Change{faster});
    session.advance(20);
    session.handle(event::Do{Pull{4, {3.5, 0.25, 0}}});
    session.advance(40);
    return session_text(*session.recorded());
}

class ReplayCommand : public testing::Test {
protected:
    std::string written(const std::string& text) const {
        std::ofstream(file()) << text;
        return file();
    }
    std::string file() const { return folder_.file("a.session"); }
    Outcome replay(const std::string& text, std::vector<std::string> more = {}) const {
        std::vector<std::string> words{"replay", written(text)};
        words.insert(words.end(), more.begin(), more.end());
        return run_program(words);
    }

    TemporaryFolder folder_;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from << " in " << text;
    return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

TEST_F(ReplayCommand, finds_the_same_hashes) {
    const Outcome outcome = replay(recorded());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "3 events, 100 steps: the same hashes\n");
    EXPECT_EQ(outcome.err, "");
}

TEST_F(ReplayCommand, names_the_first_event_that_differs) {
    const Outcome outcome = replay(replaced(recorded(), "[3.5, 0.25", "[3.5, 0.125"), {"--summary", "-"});
    EXPECT_EQ(outcome.code, 6);
    EXPECT_THAT(outcome.err, HasSubstr(file() + ": event 3 (pull) at step 60: the hash of the leading run is "));
    const Json summary = Json::parse(outcome.out);
    EXPECT_EQ(summary["status"], "differs");
    EXPECT_EQ(summary["events"], 3);
    EXPECT_THAT(summary["reason"].get<std::string>(), HasSubstr("event 3 (pull) at step 60"));
}

TEST_F(ReplayCommand, writes_a_summary) {
    const Outcome outcome = replay(recorded(), {"--summary", "-"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "3 events, 100 steps: the same hashes\n");
    const Json summary = Json::parse(outcome.out);
    EXPECT_EQ(summary["status"], "ok");
    EXPECT_EQ(summary["events"], 3);
    EXPECT_EQ(summary["steps"], 100);
    EXPECT_EQ(summary["step"], 100);
    EXPECT_EQ(summary["runs"], 1);
}

TEST_F(ReplayCommand, refuses_what_is_no_session) {
    const Outcome wrong = replay(replaced(recorded(), "do = \"change\"", "do = \"chance\""));
    EXPECT_EQ(wrong.code, 3);
    EXPECT_THAT(wrong.err, HasSubstr("unknown event 'chance' (did you mean 'change'?)"));
    EXPECT_THAT(wrong.err, HasSubstr(file() + ":"));
    EXPECT_EQ(wrong.out, "");
    EXPECT_EQ(run_program({"replay", folder_.file("none.session")}).code, 3);
    EXPECT_EQ(run_program({"replay", folder_.path()}).code, 3);
    EXPECT_EQ(run_program({"replay"}).code, 2);
    const Outcome cut = replay(recorded().substr(0, 200));
    EXPECT_EQ(cut.code, 3) << cut.err;
}

TEST_F(ReplayCommand, says_that_there_was_nothing_to_compare) {
    Session session(describe("chain", "verlet"));
    session.record(0);
    session.advance(10);
    session.handle(event::Step{5});
    std::string text = session_text(*session.recorded());
    text.resize(text.find("[end]"));
    const Outcome outcome = replay(text);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "1 event, 15 steps: the file has no hash to compare with\n");
}

// Signals are answered from before the file is read.
TEST_F(ReplayCommand, is_interrupted) {
    written(replaced(recorded(), "[end]\nstep = 100", "[end]\nstep = 100000000000000"));
    const FolderWatch watch(folder_.path(), IN_CLOSE_NOWRITE);
    RunningProgram program({"replay", file()});
    watch.wait_for_a_file();
    program.send(SIGTERM);
    EXPECT_EQ(program.wait().code, 128 + SIGTERM);
}

}  // namespace
}  // namespace steplab
