// LAMMPS dumps as any program may have written them.

#include "core/error.hpp"
#include "io/compression.hpp"
#include "io/data_bonds.hpp"
#include "io/dump_text.hpp"
#include "io/dump_trajectory.hpp"
#include "io/files.hpp"
#include "io/vtk_series.hpp"
#include "io/whole_frames.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;

std::string head(std::uint64_t step, std::uint64_t atoms, const std::string& columns,
                 const std::string& box = "BOX BOUNDS pp pp ff\n-1 3\n0 2\n10 20\n") {
    return fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: {}ITEM: ATOMS {}\n", step, atoms, box,
                       columns);
}

std::vector<FrameBlock> frames_of(const std::string& text) {
    const auto dump = TextTrajectory::open(TextInput("a.dump", std::make_shared<const std::string>(text)),
                                           TextTrajectory::From::any_program);
    std::vector<FrameBlock> frames;
    for (FrameBlock frame; dump->next(frame);) frames.push_back(std::move(frame));
    return frames;
}

std::string refusal_of(const std::string& text) {
    try {
        frames_of(text);
        return "read";
    } catch (const FileError& error) {
        return error.what();
    }
}

// The same atoms in every form that a dump has: 3 is at (2, 0.5, 12.5), in the box to the right of the first.
TEST(Dump, has_the_same_positions_in_all_forms_of_its_coordinates) {
    const std::vector<Vec3> right{{0, 1, 15}, {6, 0.5, 12.5}};
    for (const auto& [columns, rows] : std::vector<std::pair<std::string, std::string>>{
             {"id type xu yu zu", "3 1 6 0.5 12.5\n1 1 0 1 15\n"},
             {"id type x y z ix iy iz", "3 1 2 0.5 12.5 1 0 0\n1 1 0 1 15 0 0 0\n"},
             {"id type xs ys zs ix iy iz", "3 1 0.75 0.25 0.25 1 0 0\n1 1 0.25 0.5 0.5 0 0 0\n"},
             {"xsu ysu zsu id", "1.75 0.25 0.25 3\n0.25 0.5 0.5 1\n"},
             {"element id x ys zu ix", "Cu 1 0 0.5 15 0\nO 3 2 0.25 12.5 1\n"}}) {
        SCOPED_TRACE(columns);
        const auto frames = frames_of(head(7, 2, columns) + rows);
        ASSERT_EQ(frames.size(), 1u);
        EXPECT_EQ(frames[0].positions, right);
        EXPECT_EQ(frames[0].particles, (std::vector<std::size_t>{0, 2})) << "by their ids, whatever their order";
        EXPECT_EQ(frames[0].moments[0].step, 7u);
        EXPECT_EQ(frames[0].moments[0].time, 7);
        EXPECT_EQ(frames[0].scene.box, (Vec3{4, 2, 0})) << "periodic along x and y";
        EXPECT_EQ(frames[0].scene.corner, (Vec3{-1, 0, 10}));
    }
}

TEST(Dump, in_a_tilted_box_is_unwrapped_along_its_edges) {
    const std::string box = "BOX BOUNDS xy xz yz pp pp pp\n0 5 1\n0 2 0\n0 3 0\n";  // sides 4, 2, 3; y leans by 1
    const auto scaled = frames_of(head(0, 1, "id xs ys zs", box) + "1 0.25 0.5 0\n");
    EXPECT_EQ(scaled[0].positions[0], (Vec3{1.5, 1, 0}));
    const auto flags = frames_of(head(0, 1, "id x y z ix iy iz", box) + "1 1.5 1 0 0 2 0\n");
    EXPECT_EQ(flags[0].positions[0], (Vec3{3.5, 5, 0}));
    EXPECT_EQ(flags[0].scene.box, Vec3{}) << "no box along the axes";
    const Cell leaning{{Vec3{4, 0, 0}, Vec3{1, 2, 0}, Vec3{0, 0, 3}}, {}, {true, true, true}};
    EXPECT_EQ(flags[0].scene.cell, leaning);
    EXPECT_EQ(scaled[0].scene.cell, leaning);
    const std::string other = "BOX BOUNDS xy xz yz pp ff pp\n-1 5 -1\n0 2.5 0.5\n0 3 0.5\n";
    const auto back = frames_of(head(0, 1, "id xs ys zs", other) + "1 0.5 0.5 1\n");
    EXPECT_EQ(back[0].scene.cell,
              (Cell{{Vec3{4.5, 0, 0}, Vec3{-1, 2, 0}, Vec3{0.5, 0.5, 3}}, {0, 0, 0}, {true, false, true}}));
    EXPECT_EQ(back[0].positions[0], (Vec3{2.25 - 0.5 + 0.5, 1.5, 3}));
}

TEST(Dump, in_a_general_triclinic_box_has_its_edges) {
    const std::string box = "BOX BOUNDS abc origin pp pp pp\n0 2 0 5\n-3 0 0 6\n0 0 4 7\n";
    const auto frames = frames_of(head(0, 1, "id xs ys zs", box) + "1 0.5 0.5 0.25\n");
    EXPECT_EQ(frames[0].scene.cell, (Cell{{Vec3{0, 2, 0}, Vec3{-3, 0, 0}, Vec3{0, 0, 4}}, {5, 6, 7}}));
    EXPECT_EQ(frames[0].positions[0], (Vec3{3.5, 7, 8}));
    EXPECT_THAT(refusal_of(head(0, 1, "id x y z", "BOX BOUNDS abc origin pp pp pp\n1 0 0 0\n1 0 0 0\n0 0 1 0\n")),
                HasSubstr("line 8: its box is flat"));
}

TEST(Dump, has_what_else_there_is_of_numbers_by_the_ids) {
    const auto frames =
        frames_of(head(0, 3, "id element x y z vx vy vz c_pe q ix") +
                  "3 Cu 0 0 11 1 2 3 -0.5 nan 0\n1 O 1 1 12 1 2 3 2.5 7 0\n2 O 1 1 12 1 2 3 inf what 0\n");
    ASSERT_EQ(frames[0].values.size(), 2u) << "without names, positions, velocities and image flags";
    EXPECT_EQ(frames[0].values[0].name, "c_pe");
    EXPECT_EQ(frames[0].values[0].values[0], 2.5);
    EXPECT_TRUE(std::isnan(frames[0].values[0].values[1])) << "no finite number";
    EXPECT_EQ(frames[0].values[0].values[2], -0.5);
    EXPECT_EQ(frames[0].values[1].name, "q");
    EXPECT_TRUE(std::isnan(frames[0].values[1].values[1]));
    EXPECT_TRUE(std::isnan(frames[0].values[1].values[2]));
    EXPECT_EQ(frames[0].values[1].values[0], 7);
    EXPECT_TRUE(frames_of(head(0, 1, "id type mass xs ys zs") + "1 1 2 0 0 0\n")[0].values.empty());
}

TEST(Dump, may_change_its_columns_box_and_times) {
    const auto frames =
        frames_of(head(0, 1, "id x y z vx vy vz") + "1 0 1 15 1 2 3\n" + "ITEM: UNITS\nlj\nITEM: TIME\n0.5\n" +
                  head(100, 1, "type xs id ys zs", "BOX BOUNDS ff ff ff\n0 8\n0 8\n0 8\n") + "2 0.5 1 0.5 0.25\n");
    ASSERT_EQ(frames.size(), 2u);
    EXPECT_EQ(frames[0].velocities[0], (Vec3{1, 2, 3}));
    EXPECT_EQ(frames[1].positions[0], (Vec3{4, 4, 2}));
    EXPECT_TRUE(frames[1].velocities.empty()) << "none, not zeros";
    EXPECT_EQ(frames[1].moments[0].time, 0.5);
    EXPECT_EQ(frames[1].scene.box, Vec3{});
}

TEST(Dump, that_is_wrong_says_what_and_where) {
    const std::string good = head(0, 2, "id x y z") + "1 0 0 11\n2 1 1 12\n";
    EXPECT_EQ(refusal_of(good), "read");
    const auto refuses = [](const std::string& text, const std::string& message) {
        EXPECT_THAT(refusal_of(text), HasSubstr(message));
    };
    refuses(head(0, 2, "id x y z") + "1 0 0 11\n2 nan 1 12\n", "line 11: \"nan\" is not a number that can stand here");
    refuses(head(0, 2, "id x y z") + "1 0 0 11\n2 1e999 1 12\n", "line 11: ");
    refuses(head(0, 2, "id x y z") + "1 0 0 11\n2 1 12\n",
            "line 11: it has 3 columns; by ITEM: ATOMS it should have 4");
    refuses(head(0, 2, "id x y z") + "1 0 0 11\n", "it ends after 1 of the 2 atoms of a frame");
    refuses(head(0, 2147483648, "id x y z") + "1 0 0 11\n", "it ends after 1 of the 2147483648 atoms of a frame");
    refuses(head(0, 2, "id x y z") + "1 0 0 11\n1 1 1 12\n", "atom 1 is twice");
    refuses(head(0, 1, "id x y z") + "0 0 0 11\n", "ids of atoms count from 1");
    refuses(head(0, 1, "id y z") + "1 0 0\n", "no position along x");
    refuses(head(0, 0, "id x y z"), "a frame has no atoms");
    refuses(good + "hello\n", "line 12: a frame of a LAMMPS dump begins with ITEM: TIMESTEP");
    refuses(good + "ITEM: TIMESTEP\n", "it ends within the head of a frame");
    refuses("ITEM: TIMESTEP\n0\nITEM: ATOMS id x y z\n1 0 0 0\n", "ITEM: ATOMS must follow");
    refuses(head(0, 1, "id x y z", "BOX BOUNDS pp pp pp\n3 -1\n0 2\n0 2\n") + "1 0 0 0\n", "negative");
}

class DumpFile : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder_.file(name); }
    std::string written(const std::string& name, const std::string& text) const {
        put_text(path(name), text);
        return path(name);
    }

private:
    TemporaryFolder folder_;
};

TEST_F(DumpFile, has_bonds_of_a_data_file) {
    const std::string data =
        "LAMMPS data\n\n3 atoms\n2 bonds\n\nAtoms # bond\n\n1 1 1 0 0 0\n2 1 1 1 0 0\n3 1 1 2 0 0\n\nBonds\n\n"
        "1 1 1 2\n2 1 2 3 # the last\n\nVelocities\n\n1 0 0 0\n";
    EXPECT_EQ(read_data_bonds(written("a.data", data)), (std::vector<DataBond>{{0, 1}, {1, 2}}));
    EXPECT_TRUE(read_data_bonds(written("b.data", "no\n\n1 atoms\n")).empty());
    EXPECT_THROW(read_data_bonds(written("c.data", "a\n\nBonds\n\n1 1 0 2\n")), FileError);
}

TEST_F(DumpFile, takes_no_data_file_with_fewer_bonds_than_its_head_says) {
    const std::string data = "LAMMPS data\n\n2 bonds\n\nBonds\n\n1 1 1 2\n2 1 2 3\n";
    EXPECT_EQ(read_data_bonds(written("a.data", data)).size(), 2u);
    for (const std::string& cut : {data.substr(0, data.size() - 8), data.substr(0, 24), data + "3 1 1 3\n"})
        EXPECT_THROW(read_data_bonds(written("b.data", cut)), FileError) << cut;
}

FrameBlock frame_of_numbers() {
    FrameBlock frame;
    frame.scene.box = {4, 2, 0};
    frame.frame_rows = frame.rows = 2;
    frame.particles = {0, 4};
    frame.moments = {{12, 0.1 + 0.2}};
    frame.positions = {{1.0 / 3, -0.0, 1e-300}, {-2.0 / 3, 5e22, 0.1}};
    frame.velocities = {{1e-17, 3, 4}, {0.7, 0, 1.0 / 7}};
    return frame;
}

TEST(DumpText, reads_back_to_the_last_digit) {
    const FrameBlock frame = frame_of_numbers();
    std::string text;
    append_dump(text, frame);
    const auto back = frames_of(text);
    ASSERT_EQ(back.size(), 1u);
    EXPECT_EQ(back[0].positions, frame.positions);
    EXPECT_EQ(back[0].velocities, frame.velocities);
    EXPECT_EQ(back[0].particles, frame.particles);
    EXPECT_EQ(back[0].moments[0].time, frame.moments[0].time);
    EXPECT_EQ(back[0].moments[0].step, 12u);
    EXPECT_EQ(back[0].scene.box, frame.scene.box);
}

TEST(DumpText, keeps_types_masses_and_further_columns) {
    const std::string given =
        head(3, 2, "id type mass x y z c_pe v_a[1] xu") + "1 7 2.5 0 1 15 0.1 -3 9\n4 2 1 1 1 15 nan 1e-300 9\n";
    std::string text;
    append_dump(text, frames_of(given)[0]);
    const auto back = frames_of(text);
    EXPECT_EQ(back[0].types, (std::vector<std::uint64_t>{7, 2}));
    EXPECT_EQ(back[0].masses, (std::vector<double>{2.5, 1}));
    EXPECT_EQ(back[0].particles, (std::vector<std::size_t>{0, 3}));
    ASSERT_EQ(back[0].values.size(), 2u) << "x, of which the position is not made, would be taken for it";
    EXPECT_EQ(back[0].values[0].name, "c_pe");
    EXPECT_EQ(back[0].values[0].values[0], 0.1);
    EXPECT_TRUE(std::isnan(back[0].values[0].values[1]));
    EXPECT_EQ(back[0].values[1], (ParticleValues{"v_a[1]", {-3, 1e-300}}));
}

// A dump may say in several ways where its particles are; all but the one that was taken would be read with what is
// written.
TEST(DumpText, says_once_where_particles_are) {
    const std::string box = "BOX BOUNDS ff ff ff\n-1 3\n0 2\n10 20\n";
    for (const std::string more : {"xs ys zs", "xsu ysu zsu", "xu yu q", "ix iy q", "q xs ix"}) {
        const auto given = frames_of(head(3, 2, "id type x y zu zs iz " + more + " c_pe", box) +
                                     "1 7 0 1 15 0.5 1 2 3 1 9\n2 7 1 0 17 0 1 2 3 1 9\n");
        std::string text;
        append_dump(text, given.at(0));
        const auto back = frames_of(text);
        EXPECT_EQ(back.at(0).positions, given[0].positions) << text;
        EXPECT_EQ(back[0].values.back(), (ParticleValues{"c_pe", {9, 9}})) << text;
    }
}

TEST(DumpText, keeps_a_box_that_leans) {
    for (const Cell& cell : {Cell{{Vec3{4, 0, 0}, Vec3{-1, 2, 0}, Vec3{0.5, -0.25, 3}}, {1, 2, 3}, {true, false, true}},
                             Cell{{Vec3{0, 2, 0}, Vec3{-3, 0, 0}, Vec3{0, 1, 4}}, {5, 6, 7}, {true, true, true}}}) {
        FrameBlock frame = frame_of_numbers();
        frame.scene.box = {};
        frame.scene.cell = cell;
        std::string text;
        append_dump(text, frame);
        const auto back = frames_of(text);
        EXPECT_EQ(back[0].scene.cell, cell) << text;  // these bounds are sums without rounding
        EXPECT_EQ(back[0].positions, frame.positions);
    }
}

TEST_F(DumpFile, of_blocks_is_made_of_whole_frames) {
    std::vector<FrameBlock> whole;
    WholeFrames frames([&](const FrameBlock& frame) { whole.push_back(frame); });
    FrameBlock first = frame_of_numbers(), second = first;
    first.rows = 1, first.particles = {0}, first.positions.resize(1), first.velocities.resize(1);
    second.rows = 1, second.first_row = 1, second.particles = {4};
    second.positions.erase(second.positions.begin()), second.velocities.erase(second.velocities.begin());
    frames.add(first);
    EXPECT_TRUE(whole.empty());
    frames.add(second);
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_EQ(whole[0].positions, frame_of_numbers().positions);
    EXPECT_EQ(whole[0].particles, frame_of_numbers().particles);
}

TEST_F(DumpFile, is_a_series_for_vtk) {
    VtkSeries series(path("a&b.pvd"));
    series.add(frame_of_numbers());
    series.add(frame_of_numbers());
    series.finish();
    EXPECT_THAT(text_of(path("a&b.pvd")), HasSubstr("<DataSet timestep=\"0.30000000000000004\" part=\"0\" "
                                                    "file=\"a&amp;b/000001.vtp\"/>"));
    const std::string text = text_of(path("a&b") + "/000000.vtp");
    EXPECT_EQ(text, vtp_text(frame_of_numbers()));
    EXPECT_THAT(text, HasSubstr("<Piece NumberOfPoints=\"2\" NumberOfVerts=\"2\">"));
    EXPECT_THAT(text, HasSubstr("0.3333333333333333 -0 1e-300\n-0.6666666666666666 5e+22 0.1\n"));
    EXPECT_THAT(text, HasSubstr("Name=\"particle\" format=\"ascii\">\n0\n4\n"));
    Shape shape;
    shape.springs = {{0, 1, 1}};
    const std::string joined = vtp_text(frame_of_numbers(), shape);
    EXPECT_THAT(joined, HasSubstr("NumberOfVerts=\"2\" NumberOfLines=\"1\">"));
    EXPECT_THAT(joined, HasSubstr("<Lines>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n0 1\n"));
    shape.box = {0, 1, 0};
    EXPECT_EQ(vtp_text(frame_of_numbers(), shape), text) << "it leads to an image";
    written("c", "a file");
    EXPECT_THROW(VtkSeries(path("c.pvd")), FileError);
}

}  // namespace
}  // namespace steplab::test
