#include "io/text_trajectory.hpp"

#include "core/error.hpp"
#include "io/files.hpp"
#include "io/trajectory.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"

#include <gmock/gmock.h>

namespace steplab {
namespace {

using testing::HasSubstr;

template <class Add>
std::string written_by(TrajectoryFormat format, const Columns& columns, const Add& add) {
    const TemporaryFolder folder;
    OutputFile file(folder.file("a"));
    TrajectoryWriter writer(file, format, {}, {.columns = columns});
    add(writer);
    writer.finish();
    file.commit();
    return text_of(folder.file("a"));
}

/// Three frames of a run.
std::string run_as(const RunDescription& run, TrajectoryFormat format, const Columns& columns) {
    return written_by(format, columns, [&](TrajectoryWriter& writer) {
        Simulation simulation(run);
        Frame frame;
        for (int i = 0; i < 3; ++i) {
            simulation.frame(frame, writer.needs());
            writer.add(frame);
            simulation.advance(3);
        }
    });
}

std::string converted(const std::string& text, TrajectoryFormat format, Columns columns = {}) {
    const TemporaryFolder folder;
    put_text(folder.file("a"), text);
    const auto file = TextTrajectory::open(InputFile(folder.file("a")));
    if (columns.empty()) columns = file->columns();
    file->require(columns);
    return written_by(format, columns, [&](TrajectoryWriter& writer) {
        for (FrameBlock frame; file->next(frame);) writer.add(std::move(frame));
    });
}

std::string refusal(const std::string& text, const Columns& columns = {}) {
    try {
        return "read: " + converted(text, TrajectoryFormat::csv, columns);
    } catch (const FileError& error) {
        return error.what();
    }
}

TEST(TextTrajectory, gives_every_byte_back_of_every_model_in_both_precisions) {
    for (const Model& model : models()) {
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            RunDescription run = describe(model.info.id);
            run.precision = precision;
            run.dt = 0.01;
            run.scene.set("m", 0.7);
            for (const char* list : {"x,y,z,vx,vy,vz", "x,y,z", "x,y,z,ux,uy,uz", "x,y,z,vx,vy,vz,ux,uy,uz"}) {
                const Columns columns = parse_columns(list);
                for (const TrajectoryFormat format : {TrajectoryFormat::csv, TrajectoryFormat::xyz}) {
                    const std::string text = run_as(run, format, columns);
                    EXPECT_EQ(converted(text, format), text) << model.info.id << ' ' << list;
                    EXPECT_EQ(converted(text, TrajectoryFormat::csv, columns),
                              run_as(run, TrajectoryFormat::csv, columns))
                        << model.info.id << ' ' << list;
                }
            }
        }
    }
}

TEST(TextTrajectory, keeps_the_numbers_of_particles) {
    const std::string text = "step,time,particle,vx,uy\n3,0.5,2,1,2\n3,0.5,7,3,4\n4,0.6,2,5,6\n4,0.6,7,7,8e-300\n";
    EXPECT_EQ(converted(text, TrajectoryFormat::csv), text);
    EXPECT_EQ(converted(text, TrajectoryFormat::csv, parse_columns("uy")),
              "step,time,particle,uy\n3,0.5,2,2\n3,0.5,7,4\n4,0.6,2,6\n4,0.6,7,8e-300\n");
}

TEST(TextTrajectory, of_csv_has_no_roles_and_masses_for_xyz) {
    EXPECT_EQ(converted("step,time,particle,x,y,z\n0,0,0,1,2,3\n", TrajectoryFormat::xyz),
              "1\npbc=\"F F F\" Properties=species:S:1:pos:R:3 Time=0 Step=0 Precision=double\nX 1 2 3\n");
}

TEST(TextTrajectory, of_particles_that_differ_in_mass_keeps_the_mass_of_each) {
    const auto text = [](const char* second) {
        return std::string(
                   "2\npbc=\"F F F\" Properties=species:S:1:pos:R:3:masses:R:1 Time=0 Step=0\nX 1 2 3 1.5\n"
                   "X 1 2 4 ") +
               second + "\n";
    };
    for (const char* second : {"1.5", "2.5"}) {
        const std::string xyz = converted(text(second), TrajectoryFormat::xyz);
        EXPECT_THAT(xyz, HasSubstr("X 1 2 3 1.5\n")) << second;
        EXPECT_THAT(xyz, HasSubstr(std::string("X 1 2 4 ") + second + "\n")) << second;
    }
}

TEST(TextTrajectory, of_xyz_as_steplab_wrote_it_before_is_read) {
    const std::string old =
        "1\nProperties=type:S:1:pos:R:3:velo:R:3 Time=0.5 Step=5 pbc=\"F F F\"\nfixed 1 2 3 0 0 0\n";
    EXPECT_THAT(converted(old, TrajectoryFormat::xyz), HasSubstr("Properties=species:S:1:pos:R:3:velo:R:3:role:S:1 "));
}

std::string box(const std::string& lattice) {
    return "1\nLattice=\"" + lattice + "\" Origin=\"0 0 0\" Properties=pos:R:3 Time=0 Step=0\n1 2 3\n";
}

TEST(TextTrajectory, may_end_with_empty_lines) {
    EXPECT_THAT(refusal(box("5 0 0 0 5 0 0 0 5") + "\n\n"), testing::StartsWith("read: "));
}

TEST(TextTrajectory, that_is_none_is_refused_with_the_line) {
    const std::string csv = "step,time,particle,x,y,z,vx,vy,vz\n", row = "0,0,0,1,2,3,4,5,6\n";
    const std::string xyz = "2\npbc=\"F F F\" Properties=species:S:1:pos:R:3 Time=0 Step=0\nX 1 2 3\nX 1 2 3\n";
    EXPECT_THAT(refusal(csv + row), testing::StartsWith("read: "));
    EXPECT_THAT(refusal(xyz), testing::StartsWith("read: "));
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "none of steplab's formats"},
        {"hello\n", "none of steplab's formats"},
        {"run,step,time,particle,x\n", "it holds the runs of an ensemble"},
        {"step,time,particle,x,x\n", "line 1: column x is named more than once"},
        {"step,time,particle\n", "line 1: it has no columns"},
        {"step,time,particle,x,w\n", "line 1: unknown column 'w'"},
        {csv + row + "0,0,1,1,2\n", "line 3: it has 5 fields"},
        {csv + "0,0,0,1,2,3,4,5,six\n", "line 2: \"six\" is not a number"},
        {csv + "0,0,0,1,2,3,4,5,inf\n", "line 2: \"inf\""},
        {csv + "-1,0,0,1,2,3,4,5,6\n", "line 2: \"-1\""},
        {csv + "0,0,0,1,2,3,4,5,\x1b[2J\n", "line 2: \"\\x1b[2J\""},
        {"2\n\n", "line 2: the line of a frame has no Step="},
        {"0\n", "line 1: a frame has no rows"},
        {"99999999999999999999999\n", "line 1: \"99999999999999999999999\""},
        {"4000000000\n" + xyz.substr(2), "it ends after 2 of the 4000000000 rows"},
        {xyz + "1\n" + xyz.substr(2, 60), "line 7: it has 2 columns"},
        {xyz.substr(0, xyz.size() - 3) + "\n", "line 4: it has 3 columns"},
        {"1\nProperties=species:S:1:pos:R:9999999999 Time=0 Step=0\n", "line 2: pos has 9999999999 columns"},
        {"1\nProperties=pos:R:3:pos:R:3 Time=0 Step=0\n", "line 2: its Properties name pos twice"},
        {"1\nProperties=species:S:1 Time=0 Step=0\nX\n", "line 2: its Properties name none of pos, velo and disp"},
        {"1\nProperties=species:S:1:vel:R:3 Time=0 Step=0\nX 1 2 3\n", "line 2: its Properties name none of"},
        {xyz + "\n" + xyz, "line 6: a frame cannot follow an empty line"},
        {box("-5 0 0 0 -5 0 0 0 -5"), "line 2: its Lattice is not a box along the axes"},
    };
    for (const auto& [text, reason] : cases) EXPECT_THAT(refusal(text), HasSubstr(reason)) << text;
    EXPECT_THAT(refusal(csv + row, parse_columns("ux")), HasSubstr("it has no column ux, only x,y,z,vx,vy,vz"));
}

}  // namespace
}  // namespace steplab
