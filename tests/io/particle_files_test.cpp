#include "io/particle_files.hpp"

#include "core/error.hpp"
#include "io/carried_json.hpp"
#include "io/files.hpp"
#include "io/scene_file.hpp"
#include "io/scene_writer.hpp"
#include "sim/run/run_description.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <sys/stat.h>

namespace steplab {
namespace {

using testing::HasSubstr;

class ParticleFile : public testing::Test {
protected:
    static std::string scene(const std::string& block) { return "steplab = 1\n[[particles]]\n" + block + "\n"; }

    SceneOrigin read(const std::string& block, const std::string& particles) {
        put_text(folder_.file("start.xyz"), particles);
        put_text(folder_.file("scene.toml"), scene(block));
        return read_scene_file(folder_.file("scene.toml"));
    }
    Plan plan(const std::string& particles, const std::string& block = "file = \"start.xyz\"") {
        const RunDescription run = describe(read(block, particles));
        return model_of(run).plan(run.scene);
    }
    std::string refusal(const std::string& block, const std::string& particles) {
        try {
            read(block, particles);
            return "read";
        } catch (const FileError& error) {
            return error.what();
        }
    }
    TemporaryFolder folder_;
};

const std::string two =
    "2\nProperties=species:S:1:pos:R:3:velo:R:3:masses:R:1:role:S:1 Time=0 Step=0\n"
    "X 1 2 3 0.5 0 0 2 fixed\nX 4 5 6 0 0.25 0 8 bullet\n";

TEST_F(ParticleFile, gives_places_velocities_masses_and_roles) {
    const Plan scene = plan(two);
    EXPECT_EQ(scene.start[0].displacement, (Vec3{1, 2, 3}));
    EXPECT_EQ(scene.start[0].velocity, (Vec3{})) << "fixed";
    EXPECT_EQ(scene.start[1].velocity, (Vec3{0, 0.25, 0}));
    EXPECT_EQ(scene.mass, 2);
    EXPECT_EQ(scene.masses, (std::vector<double>{1, 4}));
}

TEST_F(ParticleFile, of_other_programs_needs_no_time_and_may_have_momenta_and_any_box) {
    const Plan scene = plan(
        "  2 \nLattice=\"5 0 0 1 6 0 0 0 7\" Properties=species:S:1:pos:R:3:momenta:R:3:masses:R:1:tag:I:1 pbc=\"T T "
        "T\"\nAr 0 0 0 1 0 0 2 7\nAr 1 0 0 0 3 0 4 7\n");
    EXPECT_EQ(scene.start[0].velocity, (Vec3{0.5, 0, 0}));
    EXPECT_EQ(scene.start[1].velocity, (Vec3{0, 0.75, 0}));
    EXPECT_EQ(plan("1\nmade by hand\nC 1 2 3\n").start[0].displacement, (Vec3{1, 2, 3}));
}

TEST_F(ParticleFile, of_csv_gives_its_last_step) {
    const Plan scene = plan("step,time,particle,x,y,z,vx,vy,vz\n0,0,0,1,2,3,0,0,0\n5,0.5,0,7,8,9,1,0,0\n");
    EXPECT_EQ(scene.start[0].displacement, (Vec3{7, 8, 9}));
    EXPECT_EQ(scene.start[0].velocity, (Vec3{1, 0, 0}));
}

TEST_F(ParticleFile, is_overridden_or_shifted_by_what_the_block_says) {
    const Plan scene =
        plan(two, "file = \"start.xyz\"\nposition = [10, 0, 0]\nvelocity = [0, 0, 1]\nmass = 3\nfixed = false");
    EXPECT_EQ(scene.start[0].displacement, (Vec3{11, 2, 3}));
    EXPECT_EQ(scene.start[0].velocity, (Vec3{0.5, 0, 1}));
    EXPECT_EQ(scene.mass, 3);
    EXPECT_TRUE(scene.masses.empty());
}

TEST_F(ParticleFile, is_carried_by_the_run_and_compared_by_content) {
    const SceneOrigin origin = read("file = \"start.xyz\"", two);
    ASSERT_EQ(origin->parts.size(), 2u);
    EXPECT_EQ(origin->parts[1].name, "start.xyz");
    EXPECT_EQ(origin->parts[1].content, two);
    EXPECT_EQ(origin_of(json_of(*origin)), origin) << "without the folder";
    EXPECT_NE(read("file = \"start.xyz\"", "1\n\nX 0 0 0\n"), origin) << "the same scene file";
}

TEST_F(ParticleFile, that_is_wrong_is_refused_with_the_place_in_the_scene_file) {
    const std::string block = "file = \"start.xyz\"";
    const std::vector<std::pair<std::string, const char*>> cases{
        {"", "none of steplab's formats"},
        {"2\n\nX 1 2 3\n", "line 3: it ends after 1 of the 2 rows of a frame"},
        {"1000000000000\n\nX 1 2 3\n", "it ends after 1 of the 1000000000000 rows"},
        {"1\n\nX 1 2\n", "line 3: it has 3 columns; by its Properties it should have 4"},
        {"1\n\nX 1 2 inf\n", "line 3: \"inf\" is not a number"},
        {"1\nProperties=pos:R:3:masses:R:1\n1 2 3 0\n", "the mass of particle 0 must be > 0"},
        {"1\nProperties=pos:R:3:momenta:R:3\n1 2 3 0 0 0\n", "momenta need masses"},
        {"step,time,particle,x,y\n0,0,0,1,2\n", "it has no column z"},
        {"0\n\n", "a frame has no rows"}};
    for (const auto& [text, message] : cases) {
        EXPECT_THAT(refusal(block, text), HasSubstr("scene.toml:3:8: ")) << text;
        EXPECT_THAT(refusal(block, text), HasSubstr(message)) << text;
    }
    const std::string warm = block + "\ntemperature = { kT = 1 }";
    EXPECT_THAT(refusal(warm, two), HasSubstr("scene.toml:4:15: the masses in the file differ"));
    EXPECT_THAT(refusal(block + "\nline = { count = 2 }", two),
                HasSubstr("at most one of line, grid, lattice and file"));
}

TEST_F(ParticleFile, must_be_a_file_in_the_folder_of_the_scene_links_followed) {
    namespace fs = std::filesystem;
    const TemporaryFolder elsewhere;
    put_text(elsewhere.file("far.xyz"), two);
    fs::create_symlink(elsewhere.file("far.xyz"), folder_.file("link.xyz"));
    fs::create_directory(folder_.file("sub"));
    put_text(folder_.file("sub/near.xyz"), two);
    ASSERT_EQ(mkfifo(folder_.file("pipe").c_str(), 0600), 0);
    const auto of = [&](const std::string& name) { return refusal("file = \"" + name + "\"", two); };
    EXPECT_EQ(of("sub/near.xyz"), "read");
    EXPECT_EQ(of("sub/../start.xyz"), "read");
    EXPECT_THAT(of("link.xyz"), HasSubstr("scene.toml:3:8: 'link.xyz' must lie in the folder of the scene file"));
    EXPECT_THAT(of(elsewhere.file("far.xyz")), HasSubstr("must lie in the folder"));
    EXPECT_THAT(of("../scene.toml/../x"), HasSubstr("scene.toml:3:8: "));
    EXPECT_THAT(of("missing.xyz"), HasSubstr("No such file"));
    EXPECT_THAT(of("sub"), HasSubstr("it is a folder"));
    EXPECT_THAT(of("pipe"), HasSubstr("it is not a regular file"));
    EXPECT_THAT(of("."), HasSubstr("must lie in the folder"));
}

TEST_F(ParticleFile, of_a_written_scene_lies_beside_it) {
    const RunDescription run = describe(read("file = \"start.xyz\"\ngroup = \"a\"", two));
    const std::string text = scene_file_text(run);
    EXPECT_THAT(text, HasSubstr("file = \"start.xyz\""));
    const RunDescription again = describe(scene_from({{"", text}, {"start.xyz", two}}, "b.toml"));
    EXPECT_EQ(model_of(again).scene(again.scene).particles, model_of(run).scene(run.scene).particles);
}

// In another order a frame would end at each row that does not ascend, and the last one be all there is.
TEST(ParticleFiles, refuse_rows_of_a_step_in_another_order) {
    const std::string head = "step,time,particle,x,y,z\n";
    const auto rows = [](const std::vector<int>& particles) {
        std::string text;
        for (const int particle : particles) text += "3,0.5," + std::to_string(particle) + ",1,2,3\n";
        return text;
    };
    const auto answer = [&](const std::string& text) {
        try {
            scene_from({{"", "steplab = 1\n[[particles]]\nfile = \"a.csv\"\n"}, {"a.csv", head + text}}, "a.toml");
            return std::string("read");
        } catch (const FileError& error) {
            return std::string(error.what());
        }
    };
    for (const std::vector<int>& wrong : {std::vector<int>{1, 0}, {0, 2, 1}, {2, 1, 0}, {0, 1, 1}, {4, 5, 3, 6}})
        EXPECT_THAT(answer(rows(wrong)), HasSubstr("the rows of a step must be in ascending order")) << wrong.front();
    EXPECT_EQ(answer(rows({0, 1, 2})), "read");
    EXPECT_EQ(answer(rows({0, 1, 0, 1})), "read") << "the same step once more";
    EXPECT_EQ(answer("1,0,0,1,2,3\n1,0,1,1,2,3\n" + rows({0, 1})), "read") << "another step";
}

}  // namespace
}  // namespace steplab
