// What is printed of pictures and films whose names a terminal would obey, and of an ffmpeg that prints such texts.
#include "app/hostile_names.hpp"
#include "render/record_test.hpp"

namespace steplab {
namespace {

using testing::HasSubstr;

TEST_F(Record, names_of_pictures_and_films_reach_no_terminal) {
    const Words small{"--model", "chain", "--size", "64x48", "--out"};
    const Words film{"--steps", "2", "--fps", "10", "--caption"};
    expect_safe_success(joined(joined({"snapshot"}, small), {hostile_name(".png")}), {.folder = path()});
    expect_safe_success(joined(joined(joined({"record"}, small), {hostile_name(".gif")}), film), {.folder = path()});
    expect_safe_success(joined(joined(joined({"record"}, small), {hostile_name("-%02d.png")}), film),
                        {.folder = path()});
    EXPECT_EQ(files(), 5u);  // of 0.2 s at 10 frames a second, and the two others
}

TEST_F(Record, what_ffmpeg_says_reaches_no_terminal) {
    const Outcome outcome =
        record({"--until", "1", "--out", "a.mp4"}, with_ffmpeg("printf 'no \\033[2J tape \\233' >&2\nexit 1\n"));
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("failed: no \\x1b[2J tape \\x9b; nothing of it"));
    EXPECT_TRUE(is_safe(outcome.err)) << safe_message(outcome.err);
}

// Without a display the window says what it found in its file of choices, and how to draw the scene all the same.
TEST_F(Record, names_that_the_window_prints_reach_no_terminal) {
    std::ofstream(file(hostile_name(".toml")))
        << "steplab = 1\n[[particles]]\nline = { count = 2, step = [1, 0, 0] }\n";
    std::ofstream(file(hostile_name("-choices.toml"))) << "\x1b";
    for (const char* program : {"steplab-view", "steplab"}) {
        const Outcome outcome =
            run_program({"--scene", hostile_name(".toml"), "--config", hostile_name("-choices.toml")},
                        {.program = program, .folder = path(), .environment = {"DISPLAY=", "WAYLAND_DISPLAY="}});
        EXPECT_EQ(outcome.code, 5) << safe_message(outcome.err);
        EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("note: "), HasSubstr("$'a\\x1b[2J")));
        EXPECT_TRUE(is_safe(outcome.err)) << safe_message(outcome.err);
    }
}

}  // namespace
}  // namespace steplab
