#include "render/record_test.hpp"

#include "app/folder_watch.hpp"
#include "app/png.hpp"

#include <fmt/format.h>

#include <array>
#include <csignal>
#include <cstdlib>

namespace steplab {
namespace {

namespace fs = std::filesystem;

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const Words recorded_chain{"--model", "chain", "--view", "0,10,60,9,0,0", "--size", "200x150"};

TEST_F(Record, a_film_has_every_frame_and_its_length) {
    const std::vector<std::pair<std::string, std::string>> films{
        {"a.mp4", "h264,200,150,yuv420p,31"}, {"a.webm", "vp9,200,150,yuv420p,31"}, {"a.gif", "gif,200,150,bgra,31"}};
    for (const auto& [name, expected] : films) {
        const Outcome outcome = record(joined(recorded_chain, {"--until", "1", "--out", name}));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_THAT(outcome.out, StartsWith(name + ": 31 frames, 1.033 s, 200x150 pixels"));
        EXPECT_THAT(content(name), StartsWith(expected));
        EXPECT_NEAR(seconds(name), 31.0 / 30, 0.02) << name;
    }
    EXPECT_EQ(files(), films.size()) << "nothing else is left";
}

TEST_F(Record, speed_and_rate_set_the_number_of_frames) {
    const Words options = joined(recorded_chain, {"--until", "1", "--fps", "7", "--speed", "0.3", "--out", "a.mp4"});
    ASSERT_EQ(record(options).code, 0);
    EXPECT_THAT(content("a.mp4"), HasSubstr(",24"));  // the last one at 23 * 0.3 / 7 s
    EXPECT_NEAR(seconds("a.mp4"), 24.0 / 7, 0.01);
    EXPECT_THAT(record(joined(recorded_chain, {"--steps", "0", "--out", "b.mp4"})).out, HasSubstr(": 1 frame, "));
}

// Frame k shows the last frame of the file that is no later than k / fps times the speed.
TEST_F(Record, a_trajectory_is_drawn_as_its_single_frames_are) {
    std::string text;
    for (const int t : {0, 1, 2, 4})
        text += "2\nProperties=species:S:1:pos:R:3:charge:R:1 Time=" + std::to_string(t) + "\nH 0 0 0 1\nH 1 0 " +
                std::to_string(t) + " 2\n";
    put_text(file("a.xyz"), text);
    const Words look{"--trajectory", "a.xyz",   "--view",   "10,10,20,0,0,0",
                     "--size",       "200x150", "--colour", "column:charge"};
    const Outcome outcome = record(joined(look, {"--fps", "2", "--speed", "2", "--out", "film%d.png"}));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(": 5 frames, 2.5 s, 200x150 pixels"));
    EXPECT_EQ(bytes("film2.png"), bytes("film3.png")) << "nothing new at t = 3";
    EXPECT_NE(bytes("film3.png"), bytes("film4.png"));
    EXPECT_THAT(record(joined(look, {"--until", "2", "--out", "b.mp4"})).out, HasSubstr(": 61 frames, "));
    EXPECT_EQ(record(joined(look, {"--run", "method=rk4", "--out", "c.mp4"})).code, 2) << "it is not run";
    EXPECT_EQ(record(joined(look, {"--model", "chain", "--out", "c.mp4"})).code, 2);
    EXPECT_EQ(record({"--trajectory", "none.xyz", "--out", "c.mp4"}).code, 3);
}

TEST_F(Record, films_of_a_file_that_ends_before_what_is_asked_for_say_so) {
    put_text(file("a.xyz"), "1\nTime=0\nH 0 0 0\n1\nTime=1\nH 1 0 0\n");
    const Words look{"--trajectory", "a.xyz", "--view", "0,0,9,1,0,0", "--size", "96x64", "--fps", "1"};
    EXPECT_EQ(record(joined(look, {"--until", "1", "--out", "a%d.png"})).err, "");
    const Outcome outcome = record(joined(look, {"--until", "2", "--out", "b%d.png"}));
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "steplab record: note: the file ends at step 1\n");
}

// With plots, which show all frames up to that of the picture.
TEST_F(Record, plots_of_a_file_are_those_of_its_single_frames) {
    ASSERT_EQ(
        run_program({"run", "--model", "chain", "--steps", "30", "--every", "1", "--out", file("a.trajectory")}).code,
        0);
    const Words look{"--trajectory", "a.trajectory", "--ui",    "on",     "--plots",
                     "velocity",     "--size",       "700x500", "--view", "10,10,30,9,0,0"};
    ASSERT_EQ(record(joined(look, {"--fps", "1", "--out", "film%d.png"})).code, 0);
    for (const char* const second : {"0", "2", "3"}) {
        const std::string still = std::string("still") + second + ".png";
        ASSERT_EQ(snapshot(joined(look, {"--until", second, "--out", still})).code, 0);
        EXPECT_EQ(bytes(std::string("film") + second + ".png"), bytes(still));
    }
}

/// Frames at the times 0, 1 and 2 of a file whose end is like this.
std::string three_frames(const std::string& last) {
    return "1\nTime=0\nH 0 0 0\n1\nTime=1\nH 1 0 0\n1\nTime=2\n" + last;
}

// What is whole before a fault is drawn; the fault is an error where what is asked for lies behind it.
TEST_F(Record, of_a_damaged_file_the_frames_before_the_fault_are_drawn) {
    const std::vector<std::array<std::string, 3>> damaged{{"H 2", "1", "line 9"},
                                                          {"H 2 0 0\n1\nTime=3\nH zero 0 0\n", "2", "line 12"}};
    for (const auto& [last, until, line] : damaged) {
        SCOPED_TRACE(last);
        put_text(file("a.xyz"), three_frames(last));
        const Words look{"--trajectory", "a.xyz", "--view", "0,0,9,1,0,0", "--size", "96x64"};
        const auto still = [&](const std::string& time, const std::string& out) {
            return snapshot(joined(look, {"--until", time, "--out", out}));
        };
        EXPECT_EQ(still("0", "first.png").code, 0);
        EXPECT_EQ(still(until, "good.png").code, 0);
        const Outcome behind = still("3", "behind.png");
        EXPECT_EQ(behind.code, 3);
        EXPECT_THAT(behind.err, HasSubstr(line));
        const Outcome film = record(joined(look, {"--fps", "1", "--out", "film%d.png"}));
        EXPECT_EQ(film.code, 3);
        EXPECT_THAT(film.err, HasSubstr(line));
        EXPECT_EQ(bytes("film0.png"), bytes("first.png"));
        EXPECT_EQ(bytes("film" + until + ".png"), bytes("good.png"));
    }
}

TEST_F(Record, particles_of_a_file_are_marked_by_their_numbers) {
    put_text(file("a.xyz"), "3\nTime=0\nH 0 0 0\nH 1 0 0\nH 2 0 0\n");
    const Words look{"--trajectory", "a.xyz", "--view", "0,0,9,1,0,0", "--size", "96x64"};
    ASSERT_EQ(snapshot(joined(look, {"--particle", "2,0", "--out", "two.png"})).code, 0);
    ASSERT_EQ(snapshot(joined(look, {"--out", "none.png"})).code, 0);
    EXPECT_NE(bytes("two.png"), bytes("none.png"));
    EXPECT_EQ(snapshot(joined(look, {"--particle", "3", "--out", "b.png"})).code, 2);
    EXPECT_EQ(record(joined(look, {"--particle", "1", "--out", "c%d.png"})).code, 0);
}

TEST_F(Record, of_plots_without_room_above_a_caption_is_refused) {
    const Outcome outcome = snapshot(
        {"--ui", "on", "--plots", "energies", "--size", "430x520", "--caption", "a\nb\nc\nd\ne", "--out", "a.png"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("the caption leaves no room for plots"));
    EXPECT_EQ(files(), 0U);
    EXPECT_EQ(
        snapshot({"--ui", "on", "--plots", "energies", "--size", "430x500", "--caption", "a", "--out", "a.png"}).code,
        0);
}

TEST_F(Record, sides_of_a_film_may_be_odd_where_its_format_allows_it) {
    const auto with_size = [&](const std::string& name) {
        return record({"--until", "0.1", "--size", "101x75", "--out", name});
    };
    EXPECT_EQ(with_size("a.webm").code, 0);
    EXPECT_THAT(content("a.webm"), HasSubstr(",101,75,"));
    EXPECT_EQ(with_size("a.gif").code, 0);
    const Outcome refused = with_size("a.mp4");
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("101x75"), HasSubstr("even")));
}

double mean_difference(const ReadPicture& a, const ReadPicture& b) {
    if (a.rgba.size() != b.rgba.size()) return 255;
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(a.rgba[i] - b.rgba[i]);
    return sum / static_cast<double>(a.rgba.size());
}

TEST_F(Record, a_film_shows_the_pictures_in_their_colours) {
    const Words options = joined(recorded_chain, {"--until", "1", "--fps", "5", "--background", "light"});
    ASSERT_EQ(record(joined(options, {"--out", "%d.png"})).code, 0);
    for (const std::string name : {"a.mp4", "a.webm", "a.gif"}) {
        ASSERT_EQ(record(joined(options, {"--out", name})).code, 0);
        printed("/usr/bin/ffmpeg",
                {"-v", "error", "-i", name, "-vf", "select=eq(n\\,5)", "-frames:v", "1", "-y", "of_film.png"});
        EXPECT_LT(mean_difference(read_png(file("of_film.png")), read_png(file("5.png"))), 1.5) << name;
    }
}

TEST_F(Record, a_run_that_diverges_ends_the_film_at_its_last_good_step) {
    const Words options = joined(recorded_chain, {"--method", "euler", "--dt", "2", "--steps", "2000"});
    const Outcome outcome = record(joined(options, {"--speed", "60", "--out", "%03d.png"}));
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    const std::size_t frames = files();
    EXPECT_LT(frames, 500u);
    EXPECT_EQ(snapshot(joined(options, {"--out", "snapshot.png"})).code, 4);
    EXPECT_TRUE(bytes(fmt::format("{:03}.png", frames - 1)) == bytes("snapshot.png"));
    const Outcome film = record(joined(options, {"--speed", "60", "--out", "a.mp4"}));
    EXPECT_EQ(film.code, 4);
    EXPECT_THAT(film.err, HasSubstr("diverge"));
    EXPECT_THAT(content("a.mp4"), HasSubstr(fmt::format(",{}", frames)));
}

TEST_F(Record, a_run_of_several_that_diverged_is_named_and_the_film_goes_on) {
    const Outcome outcome =
        record({"--model", "rope", "--until", "60", "--fps", "1", "--speed", "10", "--size", "64x64", "--out", "%d.png",
                "--run", "method=rk4,dt=0.01", "--run", "method=euler-forward,dt=0.01"});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("run 1: "));
    EXPECT_EQ(files(), 7u);
}

TEST_F(Record, what_cannot_be_a_film_is_wrong_usage_and_writes_nothing) {
    const std::vector<std::pair<Words, std::string>> cases{{{}, "--out FILE is required"},
                                                           {{"--out", "a.avi"}, ".webm"},
                                                           {{"--out", "-"}, ".webm"},
                                                           {{"--out", "a.png"}, "frames/%05d.png"},
                                                           {{"--out", "%d/a.png"}, "frames/%05d.png"},
                                                           {{"--out", "%d-%d.png"}, "one number"},
                                                           {{"--out", "%5d.png"}, "one number"},
                                                           {{"--out", "%00d.png"}, "one number"},
                                                           {{"--out", "%021d.png"}, "one number"},
                                                           {{"--out", "%s.png"}, "one number"},
                                                           {{"--out", "%05x.png"}, "one number"},
                                                           {{"--out", "%.png"}, "one number"},
                                                           {{"--out", "%%d.png"}, "one number"},
                                                           {{"--out", "a.mp4", "--fps", "0"}, "--fps"},
                                                           {{"--out", "a.mp4", "--fps", "1e4"}, "--fps"},
                                                           {{"--out", "a.gif", "--fps", "60"}, "50"},
                                                           {{"--out", "a.mp4", "--speed", "0"}, "--speed"},
                                                           {{"--out", "a.mp4", "--speed", "-1"}, "--speed"},
                                                           {{"--out", "a.mp4", "--until", "1e9"}, "--speed"},
                                                           {{"--out", "a.mp4", "--layout", "split"}, "--run"}};
    for (const auto& [arguments, right] : cases) {
        const Outcome outcome = record(arguments);
        EXPECT_EQ(outcome.code, 2) << testing::PrintToString(arguments) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(right));
        EXPECT_TRUE(nothing_written());
    }
}

TEST_F(Record, names_of_a_series_are_those_of_printf) {
    const Words options{"--until", "0.1", "--size", "64x64", "--fps", "10", "--out"};
    for (const auto& [pattern, second] : std::vector<std::pair<std::string, std::string>>{
             {"%d.png", "1.png"}, {"a%03d.png", "a001.png"}, {"50%%-%02db.png", "50%-01b.png"}}) {
        ASSERT_EQ(record(joined(options, {pattern})).code, 0) << pattern;
        EXPECT_TRUE(fs::exists(file(second))) << second;
    }
}

TEST_F(Record, says_when_frames_repeat) {
    const Words options{"--size", "64x64", "--out", "%02d.png", "--steps", "4"};
    EXPECT_THAT(record(options).err, HasSubstr("note: "));
    EXPECT_EQ(record(joined(options, {"--speed", "3"})).err, "");
}

TEST_F(Record, missing_folder_is_a_file_error) {
    for (const std::string name : {"nowhere/%05d.png", "nowhere/a.mp4"}) {
        const Outcome outcome = record({"--until", "1", "--out", name});
        EXPECT_EQ(outcome.code, 3);
        EXPECT_THAT(outcome.err, HasSubstr("nowhere"));
    }
}

TEST_F(Record, missing_ffmpeg_is_named_with_its_package) {
    const Outcome outcome = record({"--until", "1", "--out", "a.mp4"}, {"PATH=" + file("none")});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.err, "steplab record: cannot run ffmpeg, which writes films: install the package ffmpeg\n");
    EXPECT_TRUE(nothing_written());
    EXPECT_EQ(record({"--until", "0", "--out", "%d.png"}, {"PATH=" + file("none")}).code, 0) << "pictures need none";
}

TEST_F(Record, ffmpeg_that_fails_is_quoted_and_leaves_the_old_film) {
    std::ofstream(file("a.mp4")) << "old";
    for (const std::string when : {"", "head -c 100000 >/dev/null\n", "cat >/dev/null\n"}) {
        const Outcome outcome =
            record({"--until", "1", "--out", "a.mp4"}, with_ffmpeg(when + "echo 'no room on tape 7' >&2\nexit 1\n"));
        EXPECT_EQ(outcome.code, 3) << when;
        EXPECT_THAT(outcome.err, HasSubstr("ffmpeg, which writes films, failed: no room on tape 7; nothing of it"));
        EXPECT_EQ(bytes("a.mp4"), "old");
        EXPECT_EQ(files(), 1u);
    }
}

TEST_F(Record, what_a_failing_ffmpeg_has_written_is_kept_beside_the_old_film) {
    std::ofstream(file("a.gif")) << "old";
    const Outcome outcome = record({"--until", "1", "--out", "a.gif"},
                                   with_ffmpeg("printf half >>/dev/fd/3\necho 'tape torn' >&2\nexit 1\n"));
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("tape torn"), HasSubstr("kept in 'a.gif.partial'")));
    EXPECT_EQ(bytes("a.gif"), "old");
    EXPECT_EQ(bytes("a.gif.partial"), "half");
    EXPECT_EQ(files(), 2u);
}

TEST_F(Record, an_interrupted_film_leaves_the_old_one) {
    std::ofstream(file("a.mp4")) << "old";
    // The others read nothing, so that the program waits for them; the last one has written something.
    const std::string sleeping = "exec sleep 60\n";
    for (const Words& environment :
         {Words{}, with_ffmpeg(sleeping), with_ffmpeg("printf half >>/dev/fd/3\n" + sleeping)}) {
        std::filesystem::remove(file("a.mp4.partial"));
        const FolderWatch hidden_file(path(), IN_CREATE);
        RunningProgram program({"record", "--until", "1000", "--out", "a.mp4"},
                               {.folder = path(), .environment = environment});
        hidden_file.wait_for_a_file();
        program.send(SIGINT);
        const Outcome outcome = program.wait();
        EXPECT_EQ(outcome.code, 128 + SIGINT);
        EXPECT_EQ(bytes("a.mp4"), "old");
        const bool kept = std::filesystem::exists(file("a.mp4.partial"));
        EXPECT_EQ(kept, outcome.err.find("a.mp4.partial'") != std::string::npos) << outcome.err;
        EXPECT_EQ(files(), kept ? 2u : 1u);
    }
}

TEST_F(Record, an_interrupted_series_keeps_whole_pictures) {
    const FolderWatch pictures(path());
    RunningProgram program({"record", "--until", "1000", "--size", "320x200", "--out", "%05d.png"}, {.folder = path()});
    pictures.wait_for_a_file();
    program.send(SIGTERM);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.code, 128 + SIGTERM);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("interrupted"), HasSubstr("so far")));
    EXPECT_GE(files(), 1u);
    for (std::size_t i = 0; i < files(); ++i) EXPECT_EQ(read_png(file(fmt::format("{:05}.png", i))).width, 320);
}

// That of ffmpeg is counted in: it would hold the pictures of a GIF for a palette of all of them.
TEST_F(Record, memory_does_not_grow_with_the_frames) {
    const std::vector<Words> films{{"--size", "64x64", "--out", "%03d.png"},
                                   {"--size", "400x300", "--ui", "on", "--out", "%03d.png"},
                                   {"--size", "320x240", "--out", "a.gif"}};
    for (const Words& options : films) {
        const auto kilobytes = [&](const std::string& frames) {
            const Outcome outcome = record(joined(options, {"--model", "chain", "--fps", "1", "--until", frames}));
            EXPECT_EQ(outcome.code, 0) << outcome.err;
            return outcome.kilobytes;
        };
        EXPECT_LT(kilobytes("400"), kilobytes("60") + 8000) << testing::PrintToString(options);
    }
}

}  // namespace
}  // namespace steplab
