#include "core/error.hpp"
#include "io/files.hpp"
#include "io/series.hpp"
#include "io/summary.hpp"
#include "io/trajectory.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <locale>

namespace steplab {
namespace {

using testing::HasSubstr;

/// Two particles; the numbers are such that float and double print differently.
Frame sample_frame(Precision precision) {
    const double tenth = rounded_to(precision, 0.1);
    Frame frame;
    frame.step = 3;
    frame.time = 0.30000000000000004;
    frame.precision = precision;
    frame.positions = {{tenth, -0.0, 1e300 * (precision == Precision::double_ ? 1 : 0)}, {1, 2, 3}};
    frame.velocities = {{1e-7, 0, 12345679}, {0, 0, 0}};
    for (Vec3& v : frame.velocities) v.x = rounded_to(precision, v.x), v.z = rounded_to(precision, v.z);
    Shape shape;
    shape.roles = {Role::fixed, Role::kicked};
    frame.shape = std::make_shared<const Shape>(shape);
    frame.displacements = {{tenth, 0, 0}, {0.25, 0.5, 0}};
    frame.mass = rounded_to(precision, 2.1);
    return frame;
}

std::string written(const Frame& frame, TrajectoryFormat format, std::vector<std::size_t> particles = {},
                    const Columns& columns = {}) {
    const TemporaryFolder folder;
    OutputFile file(folder.file("a"));
    {
        TrajectoryWriter writer(file, format, describe("chain"), {std::move(particles), columns});
        writer.add(frame);
        writer.finish();
    }
    file.commit();
    return text_of(folder.file("a"));
}

TEST(Trajectory, csv_holds_the_shortest_text_of_each_number) {
    EXPECT_EQ(written(sample_frame(Precision::double_), TrajectoryFormat::csv),
              "step,time,particle,x,y,z,vx,vy,vz\n"
              "3,0.30000000000000004,0,0.1,-0,1e+300,1e-07,0,12345679\n"
              "3,0.30000000000000004,1,1,2,3,0,0,0\n");
    EXPECT_EQ(written(sample_frame(Precision::float_), TrajectoryFormat::csv, {0}),
              "step,time,particle,x,y,z,vx,vy,vz\n"
              "3,0.30000000000000004,0,0.1,-0,0,1e-07,0,12345679\n");
}

TEST(Trajectory, csv_has_the_chosen_columns_in_their_order) {
    EXPECT_EQ(written(sample_frame(Precision::double_), TrajectoryFormat::csv, {}, parse_columns("ux,vz,y")),
              "step,time,particle,ux,vz,y\n"
              "3,0.30000000000000004,0,0.1,12345679,-0\n"
              "3,0.30000000000000004,1,0.25,0,2\n");
}

TEST(Trajectory, xyz_has_the_form_that_others_read) {
    EXPECT_EQ(written(sample_frame(Precision::double_), TrajectoryFormat::xyz),
              "2\n"
              "pbc=\"F F F\" Properties=species:S:1:pos:R:3:velo:R:3:momenta:R:3:masses:R:1:role:S:1 "
              "Time=0.30000000000000004 Step=3 Precision=double\n"
              "X 0.1 -0 1e+300 1e-07 0 12345679 2.1e-07 0 25925925.900000002 2.1 fixed\n"
              "X 1 2 3 0 0 0 0 0 0 2.1 kicked\n");
}

TEST(Trajectory, xyz_of_float_has_masses_and_momenta_in_double) {
    EXPECT_THAT(written(sample_frame(Precision::float_), TrajectoryFormat::xyz, {1}),
                testing::EndsWith("Precision=float\nX 1 2 3 0 0 0 0 0 0 2.0999999046325684 kicked\n"));
}

TEST(Trajectory, xyz_has_the_chosen_vectors) {
    const Frame frame = sample_frame(Precision::double_);
    EXPECT_THAT(written(frame, TrajectoryFormat::xyz, {1}, parse_columns("ux,uy,uz,x,y,z")),
                testing::AllOf(HasSubstr("Properties=species:S:1:pos:R:3:disp:R:3:masses:R:1:role:S:1 "),
                               HasSubstr("\nX 1 2 3 0.25 0.5 0 2.1 kicked\n")));
    for (const char* columns : {"x", "ux,uy,uz", "x,y,z,vx", "vx,vy,vz"})
        EXPECT_THROW(written(frame, TrajectoryFormat::xyz, {}, parse_columns(columns)), UsageError) << columns;
}

TEST(Trajectory, xyz_has_the_periodic_box) {
    Frame frame = sample_frame(Precision::double_);
    Shape shape = *frame.shape;
    shape.box = {6.5, 6.5, 6.5};
    shape.corner = {-0.5, 0, 1};
    frame.shape = std::make_shared<const Shape>(shape);
    EXPECT_THAT(written(frame, TrajectoryFormat::xyz, {1}),
                testing::StartsWith("1\n"
                                    "Lattice=\"6.5 0 0 0 6.5 0 0 0 6.5\" Origin=\"-0.5 0 1\" pbc=\"T T T\" "
                                    "Properties=species:S:1:pos:R:3:"));
}

TEST(Trajectory, xyz_says_where_the_box_is_open) {
    Frame frame = sample_frame(Precision::double_);
    Shape shape = *frame.shape;
    shape.box = {6.5, 0, 4};
    shape.corner = {-0.5, 0, 1};
    frame.shape = std::make_shared<const Shape>(shape);
    EXPECT_THAT(written(frame, TrajectoryFormat::xyz, {1}),
                testing::StartsWith("1\nLattice=\"6.5 0 0 0 0 0 0 0 4\" Origin=\"-0.5 0 1\" pbc=\"T F T\" "));
}

TEST(Columns, are_read_from_a_list) {
    EXPECT_EQ(parse_columns("x,y,z,vx,vy,vz"), usual_columns());
    EXPECT_EQ(names_of(parse_columns("uz,x")), "uz,x");
    for (const char* list : {"", "x,", ",x", "x,,y", "X", "w", "x y", "x,x"})
        EXPECT_THROW(parse_columns(list), UsageError) << list;
}

TEST(Columns, of_a_trajectory_file_cannot_be_chosen) {
    EXPECT_THROW(written(sample_frame(Precision::double_), TrajectoryFormat::trajectory, {}, parse_columns("x")),
                 UsageError);
}

TEST(Trajectory, format_follows_the_extension) {
    EXPECT_EQ(trajectory_format_of("a.csv"), TrajectoryFormat::csv);
    for (const char* file : {"b/a.XYZ", "a.extxyz", "a.xyz.gz", "a.extxyz.ZST"})
        EXPECT_EQ(trajectory_format_of(file), TrajectoryFormat::xyz) << file;
    for (const char* file : {"a.csv.gz", "a.b.csv.zst"})
        EXPECT_EQ(trajectory_format_of(file), TrajectoryFormat::csv) << file;
    EXPECT_EQ(trajectory_format_of("a.trajectory"), TrajectoryFormat::trajectory);
    EXPECT_EQ(trajectory_format_of("-"), TrajectoryFormat::csv);
    EXPECT_EQ(trajectory_format_of("/dev/null"), TrajectoryFormat::csv);
    for (const char* file : {"a", "a.", "a.txt", ".csv", "csv", "a.gz", "a.zst", "a.txt.gz", "a.csv.gz.gz"})
        EXPECT_THROW(trajectory_format_of(file), UsageError) << file;
    EXPECT_EQ(trajectory_format("xyz"), TrajectoryFormat::xyz);
    EXPECT_THROW(trajectory_format("XYZ "), UsageError);
}

TEST(Series, line_has_a_field_for_each_name) {
    const TemporaryFolder folder;
    OutputFile file(folder.file("a"));
    SeriesWriter series(file, {.error = true});
    Diagnostics d;
    d.kinetic = 1;
    d.potential = 2;
    d.energy = 3;
    d.energy_error = -1e-9;
    d.momentum = {4, 5, 6};
    d.angular_momentum = {7, 8, 9};
    d.max_displacement = 10;
    d.max_speed = 11;
    d.error = 0.1;
    series.add(2, 0.2, d);
    d.error.reset();
    series.add(3, 0.3, d);
    file.commit();
    EXPECT_EQ(text_of(folder.file("a")),
              "step,time,kinetic,potential,energy,energy_error,px,py,pz,lx,ly,lz,max_displacement,max_speed,error\n"
              "2,0.2,1,2,3,-1e-09,4,5,6,7,8,9,10,11,0.1\n"
              "3,0.3,1,2,3,-1e-09,4,5,6,7,8,9,10,11,\n");
}

TEST(Summary, numbers_that_are_not_finite_are_null) {
    RunSummary summary;
    summary.run = describe("chain");
    summary.result.energy_start = std::numeric_limits<double>::infinity();
    summary.result.energy_end = std::numeric_limits<double>::quiet_NaN();
    summary.result.steps = 4;
    summary.result.divergence.emplace();
    const auto json = nlohmann::json::parse(summary_json(summary));
    EXPECT_TRUE(json.at("energy_start").is_null());
    EXPECT_TRUE(json.at("energy_end").is_null());
    EXPECT_EQ(json.at("energy_error"), 0);
    EXPECT_EQ(json.at("status"), "diverged");
    EXPECT_EQ(json.at("diverged_step"), 5);
    EXPECT_THAT(summary_text(summary), HasSubstr("diverged"));
}

/// A language that writes 1.234,5
struct CommaNumbers : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(Formats, do_not_depend_on_the_locale) {
    RunSummary summary;
    summary.run = describe("chain");
    summary.result.dt = 0.1;
    summary.result.steps = 1234567;
    const Frame frame = sample_frame(Precision::double_);
    const auto texts = [&] {
        return written(frame, TrajectoryFormat::csv) + written(frame, TrajectoryFormat::xyz) + summary_json(summary) +
               summary_text(summary);
    };
    const std::string plain = texts();
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
    const std::string elsewhere = texts();
    std::locale::global(before);
    EXPECT_EQ(elsewhere, plain);
    EXPECT_THAT(plain, HasSubstr("1234567"));
}

TEST(Summary, names_collisions_where_there_were_any) {
    RunSummary summary;
    summary.run = describe("chain");
    EXPECT_EQ(summary_json(summary).find("collisions"), std::string::npos);
    EXPECT_EQ(summary_text(summary).find("collisions"), std::string::npos);
    for (std::uint32_t i = 0; i < 150; ++i) summary.result.collisions.add({0.5 * i, i, i + 1});
    const nlohmann::json json = nlohmann::json::parse(summary_json(summary)).at("collisions");
    EXPECT_EQ(json.at("count"), 150);
    ASSERT_EQ(json.at("first").size(), 100u);
    EXPECT_EQ(json["first"][3]["time"], 1.5);
    EXPECT_EQ(json["first"][3]["particles"], nlohmann::json({3, 4}));
    EXPECT_NE(summary_text(summary).find("150: particles 0 and 1 at t = 0 s, 1 and 2 at 0.5 s"), std::string::npos);
}

}  // namespace
}  // namespace steplab
