// Files of scenes whose masses differ hold the mass of each particle.
#include "io/scene_file.hpp"
#include "io/trajectories.hpp"
#include "models/scene/scene_particles.hpp"
#include "support/scene_texts.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;

/// A wall and a row of three, of these masses.
std::string masses_scene(const char* fixed, double wall, double middle) {
    return fmt::format(
        "steplab = 1\n[[particles]]\ngroup = \"wall\"\nfixed = {}\nmass = {}\n[[particles]]\ngroup = \"row\"\n"
        "position = [1, 0, 0]\nline = {{ count = 3, step = [1, 0, 0] }}\nvelocity = [0.1, 0.2, 0]\n[[fix]]\n"
        "particles = \"row[1]\"\nmass = {}\n[[springs]]\npairs = [[\"wall\", \"row[0]\"]]\nk = 1\n",
        fixed, wall, middle);
}

/// The words of the rows of the last frame.
std::vector<std::vector<std::string>> rows_of(const std::string& xyz, std::size_t count) {
    std::vector<std::vector<std::string>> lines;
    std::istringstream text(xyz);
    for (std::string line; std::getline(text, line);) {
        std::istringstream words(line);
        lines.emplace_back();
        for (std::string word; words >> word;) lines.back().push_back(word);
    }
    return {lines.end() - static_cast<std::ptrdiff_t>(count), lines.end()};
}

struct Masses {
    const char* fixed;
    double wall, middle;
};
constexpr Masses all_masses[]{{"false", 1, 1}, {"true", 1, 1},   {"true", 9, 1},
                              {"false", 9, 1}, {"true", 9, 0.3}, {"false", 1, 4}};

TEST(MixedMasses, are_written_with_momenta_whichever_differ) {
    for (const auto& [fixed, wall, middle] : all_masses) {
        for (const Precision precision : {Precision::double_, Precision::float_}) {
            SCOPED_TRACE(fmt::format("{} {} {} {}", fixed, wall, middle, id(precision)));
            RunDescription run = describe(read_scene(masses_scene(fixed, wall, middle)));
            run.precision = precision;
            const std::vector<Frame> frames = frames_of(run, 2);
            const std::string xyz = written(run, frames, TrajectoryFormat::xyz);
            EXPECT_THAT(xyz, HasSubstr("Properties=species:S:1:pos:R:3:velo:R:3:momenta:R:3:masses:R:1:role:S:1"));
            const std::vector<double> masses{wall, 1, middle, 1};
            const auto rows = rows_of(xyz, 4);
            for (std::size_t i = 0; i < 4; ++i) {
                EXPECT_EQ(std::stod(rows[i][10]), masses[i]) << i;
                EXPECT_EQ(std::stod(rows[i][7]), masses[i] * frames[1].velocities[i].x) << i;
            }
            Kept kept(written(run, frames, TrajectoryFormat::trajectory));
            TrajectoryReader reader(InputFile(kept.name()));
            EXPECT_EQ(converted(reader, TrajectoryFormat::xyz), xyz);
            Frame read;
            reader.frame(1, read);
            EXPECT_EQ(read.shape->masses, frames[1].shape->masses);
            const RowOptions some{.particles = {0, 2}, .columns = {}};
            const auto chosen = rows_of(written(run, frames, TrajectoryFormat::xyz, some), 2);
            EXPECT_EQ(chosen[1], rows[2]);
        }
    }
}

TEST(MixedMasses, are_those_of_a_block_that_reads_the_file) {
    for (const auto& [fixed, wall, middle] : all_masses) {
        SCOPED_TRACE(fmt::format("{} {} {}", fixed, wall, middle));
        const RunDescription run = describe(read_scene(masses_scene(fixed, wall, middle)));
        const std::string xyz = written(run, frames_of(run, 3), TrajectoryFormat::xyz);
        const RunDescription again =
            describe(scene_from({{.name = "", .content = "steplab = 1\n[[particles]]\nfile = \"a.xyz\"\n"},
                                 {.name = "a.xyz", .content = xyz}},
                                "b.toml"));
        const Scene scene = model_of(again).scene(again.scene);
        const SceneParticles particles(scene);
        const std::vector<double> masses{wall, 1, middle, 1};
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(particles[i].mass, masses[i]) << i;
    }
}

}  // namespace
}  // namespace steplab::test
