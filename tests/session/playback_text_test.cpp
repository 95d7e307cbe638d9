#include "core/error.hpp"
#include "session/playback_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;

/// A file of text with these frames.
std::string text_file(const TemporaryFolder& folder, const Written& from, const char* name) {
    OutputFile file(folder.file(name), compression_of(name));
    TrajectoryWriter writer(file, trajectory_format_of(name), from.run);
    for (const Frame& frame : from.frames) writer.add(frame);
    writer.finish();
    file.commit();
    return folder.file(name);
}

/// A text has the shortest numbers that read back in the precision of the run.
std::vector<Vec3> held(std::vector<Vec3> vectors, Precision precision) {
    for (Vec3& v : vectors) v = {rounded_to(precision, v.x), rounded_to(precision, v.y), rounded_to(precision, v.z)};
    return vectors;
}

TEST(Playback, of_text_shows_the_same_numbers_without_a_scene) {
    for (const Precision precision : precisions) {
        const Written from(run_of("chain", "rk4", precision, 0.1));
        for (const char* const name : {"a.csv", "a.xyz", "a.extxyz", "a.csv.gz", "a.xyz.zst"}) {
            const TemporaryFolder folder;
            Playback playback(text_file(folder, from, name));
            ASSERT_EQ(playback.frames(), from.frames.size()) << name;
            for (const std::size_t i : {23u, 0u, 12u, 1u}) {
                go_to(playback, i);
                EXPECT_EQ(held(playback.frame().positions, precision), from.frames[i].positions) << name;
                EXPECT_EQ(held(playback.frame().velocities, precision), from.frames[i].velocities) << name;
                EXPECT_EQ(playback.frame().step, from.frames[i].step) << name;
                EXPECT_EQ(playback.frame().time, from.frames[i].time) << name;
            }
            const SessionView view = view_of(playback);
            EXPECT_FALSE(view.playback->measured);
            EXPECT_EQ(view.playback->fault, "");
            if (std::string_view(name).starts_with("a.csv")) continue;
            EXPECT_EQ(view.leading.frame.shape->roles, from.frames[0].shape->roles) << name;
        }
    }
}

TEST(Playback, of_text_of_another_program_has_a_frame_a_second) {
    const Kept file("1\nfirst\nH 1 2 3\n1\nsecond\nH 2 3 4\n1\nthird\nH 3 4 5\n");
    Playback playback(file.name());
    playback.handle(event::SeekTime{2});
    EXPECT_EQ(playback.frame().positions.front(), (Vec3{3, 4, 5}));
    EXPECT_EQ(playback.frame().time, 2);
}

TEST(Playback, of_text_with_steps_alone_has_their_times_from_the_first_frame_on) {
    const Kept file("1\nStep=100\nH 1 2 3\n1\nStep=200\nH 2 3 4\n1\nStep=300\nH 3 4 5\n");
    Playback playback(file.name());
    for (const std::uint64_t step : {100u, 200u, 300u}) {
        EXPECT_EQ(playback.frame().step, step);
        EXPECT_EQ(playback.frame().time, static_cast<double>(step));
        playback.handle(event::Step{1});
    }
    EXPECT_EQ(playback.frames(), 3u);
}

TEST(Playback, of_text_leaves_nothing_in_the_view_of_a_run) {
    const Kept file("1\nLattice=\"4 0 0 1 4 0 0 0 4\" Properties=species:S:1:pos:R:3:charge:R:1\nH 1 2 3 0.5\n");
    Playback playback(file.name());
    SessionView view = view_of(playback);
    ASSERT_TRUE(view.leading.frame.values && view.leading.frame.cell);
    EXPECT_EQ(view.leading.frame.values->front(), (ParticleValues{"charge", {0.5}}));
    EXPECT_EQ(played_start(file.name()).columns, std::vector<std::string>{"charge"});
    observe(Simulation(played_chain()), std::nullopt, view.leading);
    EXPECT_EQ(view.leading.frame.values, nullptr);
    EXPECT_FALSE(view.leading.frame.cell);
}

TEST(Playback, of_damaged_text_shows_the_frames_before_and_says_why) {
    const Kept file("1\n\nH 1 2 3\n1\n\nH 2 3 4\n1\n\nH 3 x 5\n");
    Playback playback(file.name());
    EXPECT_EQ(playback.frames(), 3u);
    go_to(playback, 1);
    EXPECT_THROW(go_to(playback, 2), FileError);
    EXPECT_EQ(playback.frame().positions.front(), (Vec3{2, 3, 4})) << "it stays where it is";
    const Kept broken("1\n\nH 1 2 3\n1\n\nH 2 3 4\nx\n\nH 3 4 5\n");
    EXPECT_THAT(view_of(*std::make_unique<Playback>(broken.name())).playback->fault, HasSubstr("line 7: \"x\""));
    const Kept uneven("1\n\nH 1 2 3\n2\n\nH 2 3 4\nH 3 4 5\n");
    Playback first(uneven.name());
    EXPECT_THAT(view_of(first).playback->fault, HasSubstr("has 2 rows"));
    EXPECT_THROW(Playback{Kept("nonsense").name()}, FileError);
    EXPECT_THROW(Playback{Kept("step,time,particle,x,y,z\n").name()}, FileError);
}

}  // namespace
}  // namespace steplab::test
