#include "core/error.hpp"
#include "session/playback_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
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

// The camera takes in what moves away from where it is at first, as far as numbers say.
TEST(Playback, of_rows_expects_the_places_of_its_middle_and_its_end) {
    const Kept file("1\n\nH 0 0 0\n1\n\nH 1 7 0\n1\n\nH 2 0 -3\n");
    const std::vector<Vec3> expected = {{0, 0, 0}, {1, 7, 0}, {1, 7, 0}, {2, 0, -3}, {2, 0, -3}};
    EXPECT_EQ(Playback(file.name()).frame().shape->expected, expected);
    EXPECT_EQ(Playback(file.name()).frame().shape->rest, std::vector<Vec3>(1));
    const Kept lost("1\n\nH 0 0 0\n1\n\nH nan 7 0\n1\n\nH 2 0 -3\n");
    const std::vector<Vec3> known = {{0, 0, 0}, {2, 0, -3}, {2, 0, -3}};
    EXPECT_EQ(Playback(lost.name()).frame().shape->expected, known);
}

// Its button is there for whole scenes alone.
TEST(Playback, recommends_to_continue_only_what_can_be_continued) {
    const Written from(run_of("chain", "rk4", Precision::double_, 0.1));
    const TemporaryFolder folder;
    const auto refusal = [](const std::string& file) -> std::string {
        Playback playback(file);
        try {
            playback.handle(event::Do{TurnRound{}});
        } catch (const UsageError& refused) {
            return refused.what();
        }
        return "";
    };
    const std::string continued = "\"continue from here\" begins a run";
    EXPECT_THAT(refusal(text_file(folder, from, "a.csv")), testing::Not(HasSubstr(continued)));
    EXPECT_THAT(refusal(from.path), HasSubstr(continued));
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
    observe(Simulation(played_chain()), TrackedParticles(), view.leading);
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

TEST(Playback, of_text_has_the_box_of_each_frame) {
    const auto frame = [](const std::string& side) {
        return "1\nLattice=\"" + side + " 0 0 0 " + side + " 0 0 0 " + side + "\" pbc=\"T T T\"\nH 1 2 3\n";
    };
    const Kept file(frame("4") + frame("5"));
    Playback playback(file.name());
    for (const std::size_t number : {0u, 1u, 0u}) {
        go_to(playback, number);
        const double side = number == 0 ? 4 : 5;
        EXPECT_EQ(view_of(playback).leading.frame.shape->box, (Vec3{side, side, side}));
    }
}

TEST(Playback, of_text_knows_how_far_particles_and_frames_are_apart) {
    const Kept file("2\nStep=100\nH 0 0 0\nH 0 3 0\n2\nStep=120\nH 0 0 0\nH 0 4 0\n");
    Playback playback(file.name());
    const SessionView view = view_of(playback);
    EXPECT_EQ(view.leading.frame.shape->spacing, 3) << "in the first frame";
    EXPECT_EQ(view.leading.dt, 20);
}

TEST(Playback, of_text_that_grows_waits_for_the_time_of_its_next_frame) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.xyz"), two = "1\nTime=0\nH 1 2 3\n1\nTime=1\nH 2 3 4\n";
    put_text(path, two);
    Playback playback(path);
    go_to(playback, 1);
    EXPECT_EQ(playback.next_elapsed(), 1);
    put_text(path, two + "1\nTime=4\nH 3 4 5\n");
    EXPECT_TRUE(playback.look_on());
    EXPECT_EQ(playback.frames(), 3u);
    EXPECT_EQ(playback.next_elapsed(), 4);
}

TEST(Playback, of_a_dump_in_other_units_says_so) {
    const std::string rows =
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\n"
        "ITEM: ATOMS id x y z\n1 1 1 1\n";
    const TemporaryFolder folder;
    for (const auto& [head, units] :
         std::map<std::string, std::string>{{"ITEM: UNITS\nmetal\n", "metal"}, {"ITEM: UNITS\nlj\n", ""}, {"", ""}}) {
        put_text(folder.file("a.dump"), head + rows);
        Playback playback(folder.file("a.dump"));
        EXPECT_EQ(view_of(playback).playback->units, units) << head;
    }
}

TEST(Playback, of_a_dump_draws_the_bonds_between_the_particles_that_it_has) {
    const TemporaryFolder folder;
    put_text(folder.file("a.dump"),
             "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n"
             "ITEM: ATOMS id x y z\n1 0 0 0\n3 2 0 0\n");
    put_text(folder.file("a.data"), "with atom 2\n\n2 bonds\n\nBonds\n\n1 1 1 2\n2 1 1 3\n");
    Playback playback(folder.file("a.dump"));
    const std::vector<Spring>& springs = view_of(playback).leading.frame.shape->springs;
    ASSERT_EQ(springs.size(), 1u);
    EXPECT_EQ(springs.front().first, 0u);
    EXPECT_EQ(springs.front().second, 1u);
}

TEST(Playback, of_the_dump_of_an_export_draws_the_bonds_of_its_data) {
    for (const char* const name : {"trajectory.dump", "trajectory.dump.gz", "other.dump"}) {
        const TemporaryFolder folder;
        OutputFile file(folder.file(name), compression_of(folder.file(name)));
        file.write(
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n"
            "ITEM: ATOMS id x y z\n1 0 0 0\n2 2 0 0\n");
        file.commit();
        put_text(folder.file("scene.data"), "export\n\n1 bonds\n\nBonds\n\n1 1 1 2\n");
        Playback playback(folder.file(name));
        const bool exported = std::string(name) != "other.dump";
        EXPECT_EQ(view_of(playback).leading.frame.shape->springs.size(), exported ? 1u : 0u) << name;
    }
}

}  // namespace
}  // namespace steplab::test
