// Extended XYZ of other programs: boxes that lean, further columns, and what becomes of them when they are written.

#include "io/text_trajectory.hpp"
#include "io/trajectory_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

FrameBlock frame_of(const std::string& text) {
    const auto file = TextTrajectory::open(TextInput("a.xyz", std::make_shared<const std::string>(text)),
                                           TextTrajectory::From::any_program);
    FrameBlock frame;
    file->next(frame);
    return frame;
}

std::string written(const FrameBlock& frame) {
    std::string text;
    append_xyz(text, frame, {Column::x, Column::y, Column::z});
    return text;
}

const std::string leaning =
    "1\nLattice=\"4 0 0 1 2 0 0 0.5 3\" Origin=\"1 2 3\" pbc=\"T F T\" Properties=species:S:1:pos:R:3\nH 9 9 9\n";
const std::string with_columns =
    "2\nProperties=species:S:1:pos:R:3:charge:R:1:tag:I:1:forces:R:3:fixed:L:1:stress:R:2 Time=1\n"
    "H 0 0 0 0.5 7 1 2 3 T 8 9\nO 1 1 1 nan 8 4 5 6 F 8 9\n";

TEST(XyzOfOthers, has_a_box_that_leans) {
    const FrameBlock frame = frame_of(leaning);
    const Cell cell{{Vec3{4, 0, 0}, Vec3{1, 2, 0}, Vec3{0, 0.5, 3}}, {1, 2, 3}, {true, false, true}};
    EXPECT_EQ(frame.scene.cell, cell);
    EXPECT_EQ(frame.scene.box, Vec3{});
    EXPECT_EQ(frame.positions.front(), (Vec3{9, 9, 9})) << "where the file has it";
    EXPECT_EQ(frame_of(written(frame)).scene.cell, cell);
}

TEST(XyzOfOthers, has_no_box_where_that_is_flat_or_along_the_axes) {
    const auto box_of = [](const std::string& lattice) {
        return frame_of("1\nLattice=\"" + lattice + "\"\nH 0 0 0\n").scene;
    };
    EXPECT_FALSE(box_of("1 0 0 2 0 0 0 0 1").cell);
    EXPECT_FALSE(box_of("1 0 0 1").cell);
    EXPECT_FALSE(box_of("1 0 0 0 2 0 0 0 3").cell);
    EXPECT_EQ(box_of("1 0 0 0 2 0 0 0 3").box, (Vec3{1, 2, 3}));
    EXPECT_TRUE(box_of("1 0 0 0 2 0 0.1 0 3").cell);
}

// A particle beyond a face was drawn at the other side of the box.
TEST(XyzOfOthers, has_faces_where_its_space_does_not_go_on) {
    for (const std::string flags : {"F F F", "T F T", "T T F"}) {
        const std::string text =
            "1\nLattice=\"4 0 0 0 2 0 0 0 3\" pbc=\"" + flags + "\" Properties=species:S:1:pos:R:3\nH 9 9 9\n";
        const FrameBlock frame = frame_of(text);
        ASSERT_TRUE(frame.scene.cell) << flags;
        EXPECT_EQ(frame.scene.box, Vec3{});
        const Vec3 seen = frame.scene.cell->seen({9, 9, 9});
        EXPECT_EQ(seen.x == 9, flags[0] == 'F');
        EXPECT_EQ(seen.y == 9, flags[2] == 'F');
        EXPECT_EQ(seen.z == 9, flags[4] == 'F');
        EXPECT_NE(written(frame).find("pbc=\"" + flags), std::string::npos) << written(frame);
    }
}

TEST(XyzOfOthers, has_what_else_there_is_of_numbers) {
    const FrameBlock frame = frame_of(with_columns);
    std::vector<std::string> names;
    for (const ParticleValues& column : frame.values) names.push_back(column.name);
    EXPECT_EQ(names,
              (std::vector<std::string>{"charge", "tag", "forces_x", "forces_y", "forces_z", "stress_1", "stress_2"}));
    EXPECT_EQ(frame.values[0].values[0], 0.5);
    EXPECT_TRUE(std::isnan(frame.values[0].values[1]));
    EXPECT_EQ(frame.values[3].values, (std::vector<double>{2, 5}));
}

TEST(XyzOfOthers, keeps_its_columns_when_it_is_written) {
    const FrameBlock frame = frame_of(with_columns), back = frame_of(written(frame));
    ASSERT_EQ(back.values.size(), frame.values.size());
    for (std::size_t i = 1; i < back.values.size(); ++i) EXPECT_EQ(back.values[i], frame.values[i]);
    EXPECT_TRUE(std::isnan(back.values[0].values[1]));
    EXPECT_TRUE(frame_of(leaning).values.empty());
}

TEST(XyzOfOthers, leaves_out_a_column_whose_name_cannot_be_written) {
    FrameBlock frame = frame_of(with_columns);
    frame.values = {{"a:b", {1, 2}}, {"c", {3, 4}}};
    EXPECT_EQ(frame_of(written(frame)).values, (std::vector<ParticleValues>{{"c", {3, 4}}}));
}

}  // namespace
}  // namespace steplab::test
