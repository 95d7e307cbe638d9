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

}  // namespace
}  // namespace steplab
