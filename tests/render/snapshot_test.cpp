#include "app/folder_watch.hpp"
#include "app/program.hpp"
#include "io/files.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>

namespace steplab {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// `steplab snapshot` from outside, in an empty working folder.
class Snapshot : public testing::Test {
protected:
    Outcome snapshot(std::vector<std::string> arguments, std::vector<std::string> environment = {}) const {
        arguments.insert(arguments.begin(), "snapshot");
        return run_program(arguments, {.folder = folder_.path(), .environment = std::move(environment)});
    }
    std::string bytes(const std::string& name) const { return text_of(folder_.file(name)); }
    bool nothing_written() const { return folder_.empty(); }
    std::string file(const std::string& name) const { return folder_.file(name); }
    std::string folder_path() const { return folder_.path(); }

private:
    TemporaryFolder folder_;
};

unsigned big_endian(const std::string& bytes, std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

// Mesa's software renderer would wait for ever for threads that it did not get.
TEST_F(Snapshot, has_the_same_bytes_where_no_thread_can_be_started) {
    ASSERT_EQ(snapshot({"--out", "a.png"}).code, 0);
    const Outcome alone = run_program({"snapshot", "--out", file("b.png")}, {.no_threads = true});
    EXPECT_EQ(alone.code, 0) << alone.err;
    EXPECT_TRUE(bytes("a.png") == bytes("b.png"));
}

TEST_F(Snapshot, says_where_rounding_rules_the_run) {
    const std::vector<std::string> picture{"--model", "chain",  "--precision", "float", "--steps",
                                           "2",       "--size", "90x60",       "--out", "a.png"};
    const auto notes = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = picture;
        all.insert(all.end(), more.begin(), more.end());
        return snapshot(all).err;
    };
    EXPECT_THAT(notes({"--dt", "1e-6"}), HasSubstr("steplab snapshot: note: a step of dt = 1e-6 s adds so little"));
    EXPECT_THAT(notes({"--run", "dt=0.1", "--run", "dt=1e-6"}),
                HasSubstr("steplab snapshot: note: run 1: a step of dt = 1e-6 s"));
    EXPECT_THAT(notes({"--dt", "0.1"}), testing::Not(HasSubstr("note")));
}

TEST_F(Snapshot, writes_a_png_of_the_size_asked_for) {
    const Outcome outcome = snapshot({"--out", "a.png", "--size", "200x100"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::string png = bytes("a.png");
    EXPECT_THAT(png, StartsWith("\x89PNG"));
    EXPECT_EQ(big_endian(png, 16), 200u);
    EXPECT_EQ(big_endian(png, 20), 100u);
    EXPECT_THAT(outcome.out, HasSubstr("a.png"));
}

TEST_F(Snapshot, of_a_file_is_of_its_frame_and_coloured_by_its_column) {
    std::string text;
    for (int frame = 0; frame < 3; ++frame)
        text += "2\nProperties=species:S:1:pos:R:3:charge:R:1 Step=" + std::to_string(10 * frame) +
                "\nH 0 0 0 1\nH 1 0 " + std::to_string(frame) + " 2\n";
    put_text(file("a.xyz"), text);
    const auto drawn = [&](const std::string& out, std::vector<std::string> more) {
        more.insert(more.end(), {"--trajectory", "a.xyz", "--size", "200x200", "--out", out});
        return snapshot(more);
    };
    const Outcome second = drawn("a.png", {"--steps", "15"});
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_THAT(second.out, HasSubstr("step 10, time 10 s"));
    ASSERT_EQ(drawn("b.png", {"--steps", "10"}).code, 0);
    EXPECT_EQ(bytes("a.png"), bytes("b.png")) << "the last one that is no later";
    ASSERT_EQ(drawn("c.png", {"--steps", "20"}).code, 0);
    EXPECT_NE(bytes("a.png"), bytes("c.png"));
    ASSERT_EQ(drawn("d.png", {"--steps", "20", "--colour", "column:charge"}).code, 0);
    EXPECT_NE(bytes("c.png"), bytes("d.png"));
    const Outcome wrong = drawn("e.png", {"--colour", "column:change"});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_THAT(wrong.err, HasSubstr("unknown column 'change' (did you mean 'charge'?); known: charge"));
    EXPECT_EQ(drawn("e.png", {"--model", "chain"}).code, 2) << "the scene is that of the file";
    EXPECT_EQ(snapshot({"--trajectory", "none.xyz", "--out", "e.png"}).code, 3);
}

TEST_F(Snapshot, is_1280_by_720_by_default) {
    ASSERT_EQ(snapshot({"--out", "a.png"}).code, 0);
    EXPECT_EQ(big_endian(bytes("a.png"), 16), 1280u);
    EXPECT_EQ(big_endian(bytes("a.png"), 20), 720u);
}

TEST_F(Snapshot, same_run_gives_the_same_bytes_with_the_panel_too) {
    for (const char* panel : {"off", "on"}) {
        const std::vector<std::string> common{"--steps", "20", "--ui", panel, "--size", "640x480", "--out"};
        for (const char* name : {"a.png", "b.png"}) {
            std::vector<std::string> arguments = common;
            arguments.push_back(name);
            ASSERT_EQ(snapshot(arguments).code, 0);
        }
        EXPECT_EQ(bytes("a.png"), bytes("b.png"));
    }
}

TEST_F(Snapshot, another_moment_view_or_colouring_gives_another_picture) {
    ASSERT_EQ(snapshot({"--size", "320x180", "--out", "a.png"}).code, 0);
    const std::vector<std::vector<std::string>> others{
        {"--steps", "20"},         {"--view", "top"},          {"--colour", "speed"},
        {"--background", "light"}, {"--particle", "3"},        {"--particle", "3,5-7"},
        {"--model", "rope"},       {"--view", "1,2,30,4,5,6"}, {"--scale", "2"}};
    for (std::vector<std::string> other : others) {
        other.insert(other.end(), {"--size", "320x180", "--out", "b.png"});
        ASSERT_EQ(snapshot(other).code, 0) << other[0];
        EXPECT_NE(bytes("a.png"), bytes("b.png")) << other[0];
    }
}

// The hidden file is there before the picture is computed and drawn; of this size that takes some seconds.
TEST_F(Snapshot, interrupted_while_it_draws_leaves_the_old_picture) {
    put_text(file("a.png"), "old");
    const FolderWatch hidden_file(folder_path(), IN_CREATE);
    RunningProgram program({"snapshot", "--model", "mesh", "--size", "8192x8192", "--out", "a.png"},
                           {.folder = folder_path()});
    hidden_file.wait_for_a_file();
    program.send(SIGINT);
    EXPECT_EQ(program.wait().code, 128 + SIGINT);
    EXPECT_EQ(bytes("a.png"), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_path()), {}), 1);
}

TEST_F(Snapshot, shows_an_ensemble_as_dots) {
    const auto draw = [this](const std::string& name, const std::vector<std::string>& ensemble) {
        std::vector<std::string> arguments{"--model", "morse",   "--method", "velocity-verlet",  "--dt",
                                           "0.01",    "--until", "30",       "--size",           "640x400",
                                           "--out",   name,      "--view",   "30,20,6,2,0.5,0.5"};
        arguments.insert(arguments.end(), ensemble.begin(), ensemble.end());
        const Outcome outcome = snapshot(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return bytes(name);
    };
    const std::string alone = draw("alone.png", {});
    EXPECT_EQ(draw("same.png", {"--ensemble", "9"}), alone) << "runs that do not differ hide in the run";
    const std::string ensemble = draw("ensemble.png", {"--ensemble", "9", "--spread", "v0=0.99:1.01"});
    EXPECT_NE(ensemble, alone);
    EXPECT_EQ(draw("again.png", {"--ensemble", "9", "--spread", "v0=0.99:1.01"}), ensemble);
    EXPECT_NE(draw("panel.png", {"--ensemble", "9", "--spread", "v0=0.99:1.01", "--ui", "on"}),
              draw("bare.png", {"--ui", "on"}));
}

TEST_F(Snapshot, draws_several_runs_as_ghosts_or_split) {
    const auto draw = [this](const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"--model", "rope", "--until", "2", "--size", "640x400", "--out", "a.png"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome outcome = snapshot(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return bytes("a.png");
    };
    const std::vector<std::string> runs{"--run", "method=rk4,dt=0.01", "--run", "method=euler-forward,dt=0.01"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.end(), runs.begin(), runs.end());
        return draw(more);
    };
    const std::string ghosts = with({});
    EXPECT_EQ(with({}), ghosts) << "the same runs give the same bytes";
    EXPECT_EQ(with({"--layout", "ghosts", "--magnify", "1"}), ghosts);
    EXPECT_NE(ghosts, draw({"--method", "rk4", "--dt", "0.01"}));
    EXPECT_NE(with({"--magnify", "3"}), ghosts);
    EXPECT_NE(with({"--layout", "split"}), ghosts);
    EXPECT_NE(with({"--ui", "on"}), with({"--ui", "on", "--layout", "split"}));
}

TEST_F(Snapshot, draws_arrows_and_magnified_displacements_where_they_are_asked_for) {
    const auto draw = [this](const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"--model", "chain",  "--set",   "v0=1e-6", "--until",
                                           "2",       "--size", "640x400", "--out",   "a.png"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome outcome = snapshot(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return bytes("a.png");
    };
    const std::string usual = draw({});
    EXPECT_EQ(draw({"--velocities", "off", "--forces", "off", "--displacements", "1"}), usual);
    std::vector<std::string> pictures{usual};
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--velocities", "on"}, {"--forces", "on"}, {"--displacements", "1e5"}}) {
        const std::string picture = draw(options);
        EXPECT_THAT(pictures, Not(Contains(picture))) << options[0];
        pictures.push_back(picture);
        EXPECT_EQ(draw(options), picture);
    }
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--velocities", "yes"},
                                                  {"--forces", ""},
                                                  {"--displacements", "0"},
                                                  {"--displacements", "-1"},
                                                  {"--displacements", "large"},
                                                  {"--displacements", "1e16"}}) {
        EXPECT_EQ(snapshot({"--model", "chain", wrong[0], wrong[1], "--out", "b.png"}).code, 2) << wrong[1];
    }
}

TEST_F(Snapshot, the_run_of_several_that_diverged_is_named) {
    const Outcome outcome = snapshot({"--model", "rope", "--until", "60", "--size", "64x64", "--out", "a.png", "--run",
                                      "method=rk4,dt=0.01", "--run", "method=euler-forward,dt=0.01"});
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("run 1: "));
    EXPECT_THAT(bytes("a.png"), StartsWith("\x89PNG")) << "what was computed is drawn";
}

TEST_F(Snapshot, several_runs_that_cannot_be_drawn_are_wrong_usage) {
    const std::vector<std::string> two{"--run", "method=rk4", "--run", "dt=0.05"};
    const auto with_two = [&](std::vector<std::string> more) {
        more.insert(more.end(), two.begin(), two.end());
        return more;
    };
    const std::vector<std::vector<std::string>> wrong{
        {"--run", "method=rk4"},
        {"--run", "method=none", "--run", "method=rk4"},
        {"--run", "dim=12", "--run", "dim=14"},
        {"--layout", "split"},
        {"--magnify", "2"},
        with_two({"--layout", "rows"}),
        with_two({"--magnify", "0"}),
        with_two({"--magnify", "2", "--layout", "split"}),
        with_two({"--dt", "-0.1", "--until", "-1"}),
        with_two({"--run", "dt=0.1", "--run", "dt=0.2", "--run", "dt=0.3"})};
    for (std::vector<std::string> arguments : wrong) {
        arguments.insert(arguments.end(), {"--size", "64x64", "--out", "a.png"});
        const Outcome outcome = snapshot(arguments);
        EXPECT_EQ(outcome.code, 2) << arguments[0] << " " << arguments[1] << outcome.err;
    }
    EXPECT_TRUE(nothing_written());
}

TEST_F(Snapshot, ensembles_that_cannot_be_are_wrong_usage) {
    const std::vector<std::vector<std::string>> wrong{{"--spread", "v0=1:2"},
                                                      {"--ensemble", "0"},
                                                      {"--ensemble", "1000000"},
                                                      {"--ensemble", "2", "--spread", "v0"},
                                                      {"--ensemble", "2", "--spread", "dim=10:11"}};
    for (std::vector<std::string> arguments : wrong) {
        arguments.insert(arguments.end(), {"--size", "64x64", "--out", "a.png"});
        const Outcome outcome = snapshot(arguments);
        EXPECT_EQ(outcome.code, 2) << arguments[1] << outcome.err;
    }
    EXPECT_TRUE(nothing_written());
}

TEST_F(Snapshot, goes_to_standard_output_if_asked) {
    const Outcome outcome = snapshot({"--size", "64x64", "--out", "-"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.out, StartsWith("\x89PNG"));
    EXPECT_TRUE(nothing_written());
}

TEST_F(Snapshot, wrong_values_are_wrong_usage_and_write_nothing) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"--size", "0x100"}, "8192"},
        {{"--size", "8193x100"}, "8192"},
        {{"--size", "100"}, "1280x720"},
        {{"--size", "1e3x100"}, "1280x720"},
        {{"--size", "-5x5"}, "1280x720"},
        {{"--ui", "maybe"}, "on"},
        {{"--gl", "glx"}, "osmesa"},
        {{"--view", "left"}, "front"},
        {{"--colour", "red"}, "speed"},
        {{"--background", "pink"}, "light"},
        {{"--particle", "100"}, "99"},
        {{"--particle", "3,"}, "9,0-3"},
        {{"--particle", "-1"}, "--particle"},
        {{"--scale", "0"}, "0.5"},
        {{"--steps", "-1"}, "--steps"},
        {{"--model", "mash"}, "mesh"},
        {{"--ui", "on", "--size", "399x300"}, "400x300"},
        {{"--ui", "on", "--plots", "energies", "--size", "800x459"}, "460"},
        {{"--ui", "on", "--plots", "energies", "--size", "800x600", "--scale", "2"}, "920"}};
    for (auto [arguments, right] : cases) {
        const std::string wrong = arguments[0] + " " + arguments[1];
        arguments.insert(arguments.end(), {"--out", "a.png"});
        const Outcome outcome = snapshot(arguments);
        EXPECT_EQ(outcome.code, 2) << wrong;
        EXPECT_THAT(outcome.err, HasSubstr(right)) << wrong;
        EXPECT_TRUE(nothing_written()) << wrong;
    }
}

TEST_F(Snapshot, needs_a_file_that_ends_in_png) {
    EXPECT_EQ(snapshot({}).code, 2);
    const Outcome outcome = snapshot({"--out", "a.jpg"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr(".png"));
    EXPECT_TRUE(nothing_written());
}

TEST_F(Snapshot, missing_folder_is_a_file_error) {
    const Outcome outcome = snapshot({"--out", "nowhere/a.png"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("nowhere"));
}

TEST_F(Snapshot, diverged_run_is_drawn_at_its_last_good_step) {
    const Outcome outcome =
        snapshot({"--model", "chain", "--method", "euler", "--dt", "2", "--steps", "2000", "--out", "a.png"});
    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(bytes("a.png"), StartsWith("\x89PNG"));
}

TEST_F(Snapshot, missing_shaders_are_no_opengl_and_named) {
    const Outcome outcome = snapshot({"--out", "a.png"}, {"STEPLAB_SHADERS=" + file("none")});
    EXPECT_EQ(outcome.code, 5);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(file("none")), HasSubstr(".vert")));
    EXPECT_TRUE(nothing_written());
}

TEST_F(Snapshot, missing_modules_are_no_opengl_and_named) {
    // The program alone, as if its modules had not been installed.
    const TemporaryFolder other;
    std::filesystem::create_directory(other.file("bin"));
    std::filesystem::copy_file(std::filesystem::path(STEPLAB_BINARY_DIR) / "bin/steplab", other.file("bin/steplab"));
    const Outcome outcome =
        run_program({"snapshot", "--out", "a.png"}, {.program = other.file("bin/steplab"), .folder = other.path()});
    EXPECT_EQ(outcome.code, 5);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("osmesa"), HasSubstr("egl"), HasSubstr("libosmesa6")));
    EXPECT_FALSE(std::filesystem::exists(other.file("a.png")));
}

TEST_F(Snapshot, draws_without_a_display) {
    EXPECT_EQ(snapshot({"--size", "64x64", "--out", "a.png"}, {"DISPLAY=", "WAYLAND_DISPLAY="}).code, 0);
}

TEST_F(Snapshot, largest_size_is_drawn) {
    const Outcome outcome = snapshot({"--model", "chain", "--size", "8192x256", "--out", "a.png"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(big_endian(bytes("a.png"), 16), 8192u);
}

}  // namespace
}  // namespace steplab
