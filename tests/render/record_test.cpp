#include "app/folder_watch.hpp"
#include "app/png.hpp"
#include "app/program.hpp"
#include "io/files.hpp"
#include "render/framing.hpp"
#include "sim/run/simulation.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace steplab {
namespace {

namespace fs = std::filesystem;

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

using Words = std::vector<std::string>;

Words joined(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// `steplab record` from outside, in an empty working folder.
class Record : public testing::Test {
protected:
    Outcome record(const Words& arguments, Words environment = {}) const {
        return run_program(joined({"record"}, arguments), {.folder = path(), .environment = std::move(environment)});
    }
    Outcome snapshot(const Words& arguments) const {
        return run_program(joined({"snapshot"}, arguments), {.folder = path()});
    }
    std::string path() const { return folder_.path(); }
    std::string file(const std::string& name) const { return folder_.file(name); }
    std::string bytes(const std::string& name) const { return text_of(folder_.file(name)); }
    bool nothing_written() const { return folder_.empty(); }
    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(path()), fs::directory_iterator()));
    }

    /// What a program prints that is not ours.
    std::string printed(const std::string& program, const Words& arguments) const {
        const Outcome outcome = run_program(arguments, {.program = program, .folder = path()});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out;
    }
    /// "codec,width,height,pixel format,frames" of a film.
    std::string content(const std::string& film) const {
        return printed("/usr/bin/ffprobe",
                       {"-v", "error", "-count_frames", "-show_entries",
                        "stream=codec_name,width,height,pix_fmt,nb_read_frames", "-of", "csv=p=0", film});
    }
    double seconds(const std::string& film) const {
        return std::stod(printed("/usr/bin/ffprobe", {"-v", "error", "-show_entries", "format=duration", "-of",
                                                      "default=noprint_wrappers=1:nokey=1", film}));
    }

    /// A program called ffmpeg that does what the script says, and an environment in which it is found.
    Words with_ffmpeg(const std::string& script) const {
        const std::string place = programs_.file("ffmpeg");
        std::ofstream(place) << "#!/bin/sh\n" << script;
        fs::permissions(place, fs::perms::owner_all);
        return {"PATH=" + programs_.path() + ":/usr/bin:/bin"};
    }

private:
    TemporaryFolder folder_, programs_;
};

/// A case in which a film is compared with snapshots.
struct Pictured {
    std::string name;
    Words options;
    int frames, steps_a_frame;
};

class RecordedFrames : public Record, public testing::WithParamInterface<Pictured> {};

TEST_P(RecordedFrames, are_the_bytes_of_snapshots) {
    const auto& [name, options, frames, steps] = GetParam();
    const Outcome outcome = record(joined(options, {"--out", "f%03d.png"}));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(files(), static_cast<std::size_t>(frames));
    for (int frame = 0; frame < frames; ++frame) {
        Words picture{"--steps", std::to_string(frame * steps), "--out", "snapshot.png"};
        for (std::size_t i = 0; i < options.size(); i += 2) {
            const std::string& option = options[i];
            if (option != "--until" && option != "--fps" && option != "--speed")
                picture = joined(picture, {option, options[i + 1]});
        }
        ASSERT_EQ(snapshot(picture).code, 0);
        EXPECT_TRUE(bytes(fmt::format("f{:03}.png", frame)) == bytes("snapshot.png")) << "frame " << frame;
    }
}

const Words small{"--size", "200x150"}, with_panel{"--ui", "on", "--size", "640x400"};
const Words chain_alone{"--model", "chain", "--view", "0,10,60,9,0,0"}, chain = joined(chain_alone, small);
const Words rope{"--model", "rope", "--until", "2", "--view", "0,0,30,5,-3,0"};
const Words two_runs{"--run", "method=rk4,dt=0.01", "--run", "method=euler,dt=0.05"};

INSTANTIATE_TEST_SUITE_P(
    Films, RecordedFrames,
    testing::Values(
        Pictured{"chain", joined(chain, {"--until", "2", "--fps", "10", "--speed", "4"}), 6, 4},
        Pictured{"backward", joined(chain, {"--dt", "-0.1", "--until", "-1", "--fps", "5"}), 6, 2},
        Pictured{"float_run", joined(chain, {"--precision", "float", "--until", "5", "--fps", "1"}), 6, 10},
        Pictured{"adaptive", joined(chain, {"--method", "dopri5", "--until", "1", "--fps", "5"}), 6, 2},
        Pictured{"ghosts", joined(joined(rope, two_runs), {"--size", "300x200", "--fps", "2"}), 5, 50},
        Pictured{"split", joined(joined(rope, two_runs), {"--size", "300x200", "--fps", "2", "--layout", "split"}), 5,
                 50},
        Pictured{"ensemble", joined(chain, {"--until", "4", "--fps", "1", "--ensemble", "5", "--spread", "k=0.9:1.1"}),
                 5, 10},
        Pictured{"panel", joined(joined(chain_alone, with_panel), {"--until", "20", "--fps", "1", "--speed", "4"}), 6,
                 40},
        Pictured{"panel_of_runs", joined(joined(joined(rope, two_runs), with_panel), {"--fps", "2"}), 5, 50}),
    [](const auto& test) { return test.param.name; });

// Beyond 400 steps the plots of a film have the samples of its end from the beginning: no step is taken twice for them.
TEST_F(Record, last_frame_with_the_panel_is_a_snapshot_in_long_runs_too) {
    const Words options = joined(chain_alone, with_panel);
    ASSERT_EQ(record(joined(options, {"--until", "100", "--fps", "1", "--speed", "50", "--out", "%d.png"})).code, 0);
    ASSERT_EQ(snapshot(joined(options, {"--steps", "1000", "--out", "snapshot.png"})).code, 0);
    EXPECT_TRUE(bytes("2.png") == bytes("snapshot.png"));
}

TEST_F(Record, last_frame_at_a_shortened_step_is_a_snapshot) {
    const Words options = joined(chain, {"--method", "dopri5", "--until", "1.05"});
    ASSERT_EQ(record(joined(options, {"--fps", "20", "--out", "%02d.png"})).code, 0);
    ASSERT_EQ(snapshot(joined(options, {"--out", "snapshot.png"})).code, 0);
    EXPECT_TRUE(bytes("21.png") == bytes("snapshot.png"));
    EXPECT_FALSE(bytes("20.png") == bytes("snapshot.png"));
}

TEST_F(Record, has_the_same_bytes_each_time) {
    for (const char* name : {"a%02d.png", "b%02d.png"})
        ASSERT_EQ(record({"--until", "2", "--size", "160x120", "--out", name, "--fps", "5"}).code, 0);
    for (int i = 0; i <= 10; ++i)
        EXPECT_TRUE(bytes(fmt::format("a{:02}.png", i)) == bytes(fmt::format("b{:02}.png", i))) << i;
}

// Two particles that fly apart: a camera that followed the scene would go back.
TEST_F(Record, keeps_the_camera_of_its_first_frame) {
    const Words options{"--model", "free", "--set", "n=2", "--size", "200x150"};
    ASSERT_EQ(record(joined(options, {"--until", "40", "--fps", "1", "--speed", "20", "--out", "%d.png"})).code, 0);
    RunDescription description = describe("free");
    description.scene.set_text("n", "2");
    const render::Camera camera = render::default_camera(Simulation(description).frame(), {200, 150});
    const Words there = joined(options, {"--steps", "400", "--out"});
    ASSERT_EQ(snapshot(joined(there, {"same.png", "--view", render::view_text(camera)})).code, 0);
    ASSERT_EQ(snapshot(joined(there, {"framed.png"})).code, 0);
    EXPECT_TRUE(bytes("2.png") == bytes("same.png"));
    EXPECT_FALSE(bytes("2.png") == bytes("framed.png"));
}

TEST_F(Record, a_film_has_every_frame_and_its_length) {
    const std::vector<std::pair<std::string, std::string>> films{
        {"a.mp4", "h264,200,150,yuv420p,31"}, {"a.webm", "vp9,200,150,yuv420p,31"}, {"a.gif", "gif,200,150,bgra,31"}};
    for (const auto& [name, expected] : films) {
        const Outcome outcome = record(joined(chain, {"--until", "1", "--out", name}));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_THAT(outcome.out, StartsWith(name + ": 31 frames, 1.033 s, 200x150 pixels"));
        EXPECT_THAT(content(name), StartsWith(expected));
        EXPECT_NEAR(seconds(name), 31.0 / 30, 0.02) << name;
    }
    EXPECT_EQ(files(), films.size()) << "nothing else is left";
}

TEST_F(Record, speed_and_rate_set_the_number_of_frames) {
    const Words options = joined(chain, {"--until", "1", "--fps", "7", "--speed", "0.3", "--out", "a.mp4"});
    ASSERT_EQ(record(options).code, 0);
    EXPECT_THAT(content("a.mp4"), HasSubstr(",24"));  // the last one at 23 * 0.3 / 7 s
    EXPECT_NEAR(seconds("a.mp4"), 24.0 / 7, 0.01);
    EXPECT_THAT(record(joined(chain, {"--steps", "0", "--out", "b.mp4"})).out, HasSubstr(": 1 frame, "));
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
    const Words options = joined(chain, {"--until", "1", "--fps", "5", "--background", "light"});
    ASSERT_EQ(record(joined(options, {"--out", "%d.png"})).code, 0);
    for (const std::string name : {"a.mp4", "a.webm", "a.gif"}) {
        ASSERT_EQ(record(joined(options, {"--out", name})).code, 0);
        printed("/usr/bin/ffmpeg",
                {"-v", "error", "-i", name, "-vf", "select=eq(n\\,5)", "-frames:v", "1", "-y", "of_film.png"});
        EXPECT_LT(mean_difference(read_png(file("of_film.png")), read_png(file("5.png"))), 1.5) << name;
    }
}

TEST_F(Record, a_run_that_diverges_ends_the_film_at_its_last_good_step) {
    const Words options = joined(chain, {"--method", "euler", "--dt", "2", "--steps", "2000"});
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
        EXPECT_THAT(outcome.err, HasSubstr("ffmpeg, which writes films, failed: no room on tape 7"));
        EXPECT_EQ(bytes("a.mp4"), "old");
        EXPECT_EQ(files(), 1u);
    }
}

TEST_F(Record, an_interrupted_film_is_not_kept) {
    std::ofstream(file("a.mp4")) << "old";
    // The second one reads nothing, so that the program waits for it.
    for (const Words& environment : {Words{}, with_ffmpeg("exec sleep 60\n")}) {
        const FolderWatch hidden_file(path(), IN_CREATE);
        RunningProgram program({"record", "--until", "1000", "--out", "a.mp4"},
                               {.folder = path(), .environment = environment});
        hidden_file.wait_for_a_file();
        program.send(SIGINT);
        EXPECT_EQ(program.wait().code, 128 + SIGINT);
        EXPECT_EQ(bytes("a.mp4"), "old");
        EXPECT_EQ(files(), 1u);
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
