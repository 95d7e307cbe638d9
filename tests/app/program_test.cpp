#include "app/program.hpp"

#include "app/commands/commands.hpp"
#include "io/files.hpp"

#include <gmock/gmock.h>

#include <sys/stat.h>

namespace steplab {
namespace {

using testing::HasSubstr;

const std::string program = std::string(STEPLAB_BINARY_DIR) + "/bin/steplab";

/// A folder with the program alone in it, as on a machine without the window.
struct ProgramAlone {
    TemporaryFolder folder;
    std::string path = folder.file("steplab");
    ProgramAlone() { std::filesystem::copy_file(program, path); }

    /// Takes the place of the window program and prints its command line.
    void add_window_program() const {
        put_text(folder.file("steplab-view"), "#!/bin/sh\nprintf '%s\\n' \"$0\" \"$@\"\nexit 7\n");
        chmod(folder.file("steplab-view").c_str(), 0700);
    }
};

TEST(Program, needs_no_drawing_library) {
    const Outcome libraries = run_program({program}, {.program = "/usr/bin/ldd"});
    ASSERT_EQ(libraries.code, 0) << libraries.err;
    EXPECT_THAT(libraries.out, HasSubstr("libc.so"));
    for (const char* library :
         {"libGL", "libOpenGL", "libEGL", "libGLEW", "libglfw", "libOSMesa", "libX", "libwayland", "libimgui"}) {
        EXPECT_THAT(libraries.out, testing::Not(HasSubstr(library)));
    }
}

TEST(Program, without_a_window_names_the_alternatives) {
    const ProgramAlone alone;
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{}, {"view"}, {"--model", "rope", "--dt", "0.02"}, {"view", "--model", "rope"}}) {
        const Outcome outcome = run_program(words, {.program = alone.path});
        EXPECT_EQ(outcome.code, 5);
        for (const char* word : {"steplab-view", "steplab snapshot", "steplab run"})
            EXPECT_THAT(outcome.err, HasSubstr(word));
    }
    EXPECT_EQ(run_program({"run", "--steps", "1"}, {.program = alone.path}).code, 0);
}

TEST(Program, becomes_the_window_beside_it) {
    const ProgramAlone alone;
    alone.add_window_program();
    const Surroundings surroundings{.program = alone.path};
    EXPECT_THAT(run_program({}, surroundings).out, testing::EndsWith("/steplab-view\n"));
    const Outcome bare = run_program({"--model", "rope", "--set", "n=5"}, surroundings);
    EXPECT_EQ(bare.code, 7);
    EXPECT_THAT(bare.out, testing::EndsWith("--model\nrope\n--set\nn=5\n"));
    EXPECT_THAT(run_program({"view", "--dt=0.5"}, surroundings).out, testing::EndsWith("steplab-view\n--dt=0.5\n"));
}

TEST(Program, reports_wrong_scenes_before_a_window_opens) {
    const ProgramAlone alone;
    alone.add_window_program();
    const Outcome outcome = run_program({"--model", "ropes"}, {.program = alone.path});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("did you mean 'rope'"));
}

TEST(Program, help_shows_every_command_and_each_has_its_own) {
    const std::string help = run_program({"--help"}).out;
    for (const auto& command : commands({})) {
        EXPECT_THAT(help, HasSubstr("  " + std::string(command->name()) + ' '));
        EXPECT_THAT(help, HasSubstr(std::string(command->what())));
        const Outcome own = run_program({std::string(command->name()), "--help"});
        EXPECT_EQ(own.code, 0);
        EXPECT_THAT(own.out, HasSubstr("Usage: steplab " + std::string(command->name())));
        EXPECT_THAT(own.out, testing::Not(testing::EndsWith("\n\n")));
        EXPECT_EQ(run_program({"help", std::string(command->name())}).out, own.out);
    }
}

TEST(Program, help_is_a_command_too) {
    const Outcome help = run_program({"help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_EQ(help.out, run_program({"--help"}).out);
    EXPECT_EQ(run_program({"help", "help"}).out, help.out);
    EXPECT_EQ(run_program({"help", "--help"}).out, help.out);
    for (const char* code : {"0 done", "2 wrong", "3 a file", "4 the run diverged", "5 no OpenGL", "6 a repeated run"})
        EXPECT_THAT(help.out, HasSubstr(code));
}

TEST(Program, numbers_do_not_depend_on_the_language_of_the_user) {
    const std::vector<std::string> words{"run", "--model", "chain", "--dt", "0.05", "--steps", "3", "--out", "-"};
    const std::string plain = run_program(words, {.environment = {"LC_ALL=C"}}).out;
    EXPECT_THAT(plain, HasSubstr("3,0.15000000000000002,"));
    EXPECT_EQ(run_program(words, {.environment = {"LC_ALL=de_DE.UTF-8", "LANG=de_DE.UTF-8"}}).out, plain);
}

}  // namespace
}  // namespace steplab
