// What the blocks of a scene file mean together: which problem is reported, and where.
#include "io/scene_file.hpp"
#include "sim/run/run_description.hpp"
#include "support/scene_texts.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A line, a grid, a grid of one column, a lattice and a single particle, 15 lines long.
const std::string groups = R"(steplab = 1
[[particles]]
group = "line"
line = { count = 4, step = [1, 0, 0] }
[[particles]]
group = "grid"
grid = { count = [3, 2], steps = [[1, 0, 0], [0, 1, 0]] }
[[particles]]
group = "column"
grid = { count = [1, 3], steps = [[1, 0, 0], [0, 1, 0]] }
[[particles]]
group = "metal"
lattice = { kind = "fcc", cells = [2, 2, 2], constant = 2 }
[[particles]]
group = "single"
)";

TEST(SceneChecks, springs_join_neighbours_of_lines_and_grids_only) {
    for (const char* group : {"line", "grid", "column", "metal", "single"}) {
        for (const char* along : {"", "axes", "diagonals", "both"}) {
            const std::string way = *along ? fmt::format("along = \"{}\"\n", along) : "";
            const std::string answer =
                refusal_of_scene(groups + fmt::format("[[springs]]\nk = 1\nbetween = \"{}\"\n{}", group, way));
            SCOPED_TRACE(fmt::format("{} {}: {}", group, along, answer));
            const std::string name = group, direction = along;
            if (name == "metal")
                EXPECT_THAT(answer, StartsWith("a.toml:18:11: group 'metal' is a lattice"));
            else if (name != "grid" && name != "column" && !direction.empty())
                EXPECT_THAT(answer, StartsWith(fmt::format("a.toml:19:9: group '{}' is no grid", group)));
            else if (name == "single")
                EXPECT_THAT(answer, StartsWith("a.toml:18:11: group 'single' has one particle"));
            else if (name == "column" && direction == "diagonals")
                EXPECT_THAT(answer, StartsWith("a.toml:19:9: a grid of 1 x 3 particles has no diagonals"));
            else
                EXPECT_EQ(answer, "read");
        }
    }
    EXPECT_THAT(refusal_of_scene(groups + "[[springs]]\nk = 1\npairs = [[0, 1]]\nalong = \"axes\"\n"),
                StartsWith("a.toml:19:9: along is a direction in a grid"));
    EXPECT_EQ(refusal_of_scene(groups + "[[springs]]\nk = 1\npairs = [[\"metal[0]\", \"metal[1]\"]]\n"), "read");
}

TEST(SceneChecks, blocks_without_effect_are_refused) {
    const std::vector<std::pair<std::string, const char*>> cases{
        {"[[particles]]\nline = { count = 5 }", "a.toml:17:8: a line needs a step"},
        {"[[particles]]\nline = { count = 1 }", "read"},
        {"[[particles]]\nline = { count = 5, step = [0, 0, 0] }", "read"},
        {"[[particles]]\ngrid = { count = [2, 1] }", "a.toml:17:8: a grid needs steps"},
        {"[[particles]]\ngrid = { count = [1, 1] }", "read"},
        {"[[particles]]\ntemperature = {}", "a.toml:17:15: a temperature needs kT"},
        {"[[particles]]\ntemperature = { seed = 3 }", "a.toml:17:15: a temperature needs kT"},
        {"[[particles]]\ntemperature = { kT = 0 }", "read"},
        {"[[particles]]\ndisplacement = {}", "a.toml:17:16: a displacement needs random"},
        {"[[particles]]\ndisplacement = { seed = 3 }", "a.toml:17:16: a displacement needs random"},
        {"[[particles]]\ndisplacement = { random = 0 }", "read"},
        {"[[fix]]\nparticles = \"line\"", "a.toml:16:1: [[fix]] sets nothing"},
        {"[[fix]]\nparticles = \"line\"\ncharge = 0", "read"},
        {"[[fields]]", "a.toml:16:1: [[fields]] does nothing"},
        {"[[fields]]\nparticles = \"line\"", "a.toml:16:1: [[fields]] does nothing"},
        {"[[fields]]\ndrag = 0", "read"},
        {"[box]\ncorner = [0, 0, 0]", "a.toml:16:1: [box] needs a size"},
        {"[box]\nsize = [0, 0, 0]", "read"}};
    for (const auto& [block, message] : cases)
        EXPECT_THAT(refusal_of_scene(groups + block + "\n"), StartsWith(message)) << block;
}

TEST(SceneChecks, names_are_refused_where_they_stand) {
    const std::vector<std::pair<std::string, const char*>> cases{
        {"[[fix]]\nfixed = true\nparticles = [\"line[0]\", \"lime\"]", "a.toml:18:25: unknown group 'lime'"},
        {"[[fix]]\nfixed = true\nparticles = [0, \"grid[3,0]\"]", "a.toml:18:17: "},
        {"[[fix]]\nfixed = true\nparticles = [0, 99]", "a.toml:18:17: the scene has no particle 99"},
        {"[[fix]]\nfixed = true\nparticles = \"line[4]\"", "a.toml:18:13: group 'line' has no particle 4"},
        {"[[springs]]\nk = 1\npairs = [[0, 1], [\"line[0]\", \"line[9]\"]]", "a.toml:18:18: group 'line' has no"},
        {"[[springs]]\nk = 1\npairs = [[0, 1], [1, 1]]", "a.toml:18:18: a spring from '1' to itself"},
        {"[[springs]]\nk = 1\npairs = [[0, 1], [1, \"lime\"]]", "a.toml:18:18: unknown group 'lime'"},
        {"[[springs]]\nk = 1\nbetween = \"lime\"", "a.toml:18:11: unknown group 'lime'"},
        {"[[pairs]]\npotential = \"r\"\nbetween = [\"line\", \"lime\"]", "a.toml:18:20: unknown group 'lime'"},
        {"[[pairs]]\npotential = \"r\"\nbetween = \"line[9]\"", "a.toml:18:11: group 'line' has no particle 9"},
        {"[[pairs]]\npotential = \"r\"\nbetween = \"single\"", "a.toml:18:11: a pair force within one particle"},
        {"[[pairs]]\npotential = \"r\"\ncutoff = 4\n[box]\nsize = [9, 9, 9]", "a.toml:18:10: the box is 9 long"},
        {"[[fields]]\ndrag = 1\nparticles = [\"line\", \"lime\"]", "a.toml:18:22: unknown group 'lime'"},
        {"[[fields]]\ndrag = 1\nparticles = \"line[5]\"", "a.toml:18:13: group 'line' has no particle 5"},
        {"[start]\namplitude = 1\nmode = 99", "a.toml:18:8: there is no normal mode 99"}};
    for (const auto& [block, message] : cases)
        EXPECT_THAT(refusal_of_scene(groups + block + "\n"), StartsWith(message)) << block;
}

// Each of these is wrong alone, in line 2 of the block. Of any two the one that comes first in the file is reported.
TEST(SceneChecks, the_first_problem_of_a_file_is_reported) {
    const std::vector<std::string> wrong{"[[particles]]\nmass = 0\n",
                                         "[[particles]]\ngroup = \"line\"\n",
                                         "[[fix]]\nparticles = \"lime\"\nfixed = true\n",
                                         "[[fix]]\nparticles = \"line\"\nmass = -1\n",
                                         "[[springs]]\nbetween = \"lime\"\nk = 1\n",
                                         "[[springs]]\nk = -1\nbetween = \"line\"\n",
                                         "[[pairs]]\npotential = \"expp(r)\"\n",
                                         "[[pairs]]\nbetween = \"lime\"\npotential = \"r\"\n",
                                         "[[fields]]\ndrag = -1\n",
                                         "[[fields]]\nparticles = \"lime\"\ndrag = 1\n",
                                         "[parameters]\nk = { value = 1, range = [2, 1] }\n",
                                         "[box]\nsize = [1, 1]\n",
                                         "[run]\nmethod = \"rk5\"\n",
                                         "[start]\nreverse = 1\n",
                                         "[view]\ncolour = \"sped\"\n",
                                         "[[nothing]]\n"};
    const auto line_of = [](const std::string& answer) {
        EXPECT_THAT(answer, StartsWith("a.toml:"));
        return answer.size() > 7 ? std::stoi(answer.substr(7)) : 0;
    };
    for (const std::string& first : wrong) {
        const int alone = line_of(refusal_of_scene(groups + first));
        EXPECT_GE(alone, 16) << first;
        for (const std::string& second : wrong) {
            if (&first == &second) continue;
            EXPECT_EQ(line_of(refusal_of_scene(groups + first + second)), alone) << first << second;
        }
    }
}

// A number that cannot be had from a wrong parameter hides nothing that stands before it.
TEST(SceneChecks, a_wrong_parameter_is_reported_where_it_stands) {
    const std::string wrong = "[parameters]\nk = \"1 / 0\"\n";
    EXPECT_THAT(refusal_of_scene(groups + "[[springs]]\nk = \"k\"\nbetween = \"line\"\n" + wrong),
                StartsWith("a.toml:20:5: its value is not finite"));
    EXPECT_THAT(refusal_of_scene(groups + "[[springs]]\nk = \"k\"\nbetween = \"lime\"\n" + wrong),
                StartsWith("a.toml:18:11: unknown group"));
    EXPECT_THAT(refusal_of_scene(groups + "[[springs]]\nk = \"k\"\ndamping = -1\nbetween = \"line\"\n" + wrong),
                StartsWith("a.toml:18:11: must be >= 0"));
    const std::string chain = "[[springs]]\nk = \"j\"\nbetween = \"line\"\n[parameters]\nj = \"k\"\nk = {}\n";
    EXPECT_THAT(refusal_of_scene(groups + chain), StartsWith("a.toml:21:5: parameter 'k' needs a value"));
}

TEST(SceneChecks, pair_potentials_are_finite_where_pairs_start) {
    const std::string pair =
        "steplab = 1\n[[particles]]\ngroup = \"a\"\n[[particles]]\ngroup = \"b\"\nposition = [1, 0, 0]\n"
        "[[pairs]]\npotential = ";
    const std::vector<std::pair<const char*, const char*>> cases{
        {"r/0", "a.toml:8:13: "},
        {"log(-1)*r", "a.toml:8:13: "},
        {"log(r-2)", "a.toml:8:13: the potential is not finite at r = 1, where particles 0 and 1 start"},
        {"(r-3)^2.5", "a.toml:8:13: the potential is not finite at r = 1"},
        {"sqrt(r-1)", "a.toml:8:13: the potential is not finite at r = 1"},  // its force is not
        {"1/(r-1)", "a.toml:8:13: the potential is not finite at r = 1"},
        {"log(r)", "read"},
        {"1/r", "read"},
        {"abs(r-1)", "read"},
        {"log(2-r)", "read"}};
    for (const auto& [potential, message] : cases)
        EXPECT_THAT(refusal_of_scene(pair + "\"" + potential + "\"\n"), StartsWith(message)) << potential;
    const std::string beyond = "\"log(2-r)\"\ncutoff = ";
    EXPECT_EQ(refusal_of_scene(pair + beyond + "1.5\n"), "read");
    EXPECT_THAT(refusal_of_scene(pair + beyond + "3\n"), StartsWith("a.toml:8:13: the potential is not finite at its"));
    EXPECT_EQ(refusal_of_scene(pair + "\"log(r-2)\"\n[[fix]]\nparticles = \"b\"\ndisplacement = [5, 0, 0]\n"), "read");
    EXPECT_EQ(refusal_of_scene(pair + "\"log(r-2)\"\n[[fix]]\nparticles = \"all\"\nfixed = true\n"), "read")
        << "it does not act";
    const std::string row = "steplab = 1\n[[particles]]\nline = { count = 2000, step = [1, 0, 0] }\n[[pairs]]\n";
    EXPECT_THAT(refusal_of_scene(row + "potential = \"log(r-1.5)\"\n"), HasSubstr("not finite at r = 1")) << "of many";
}

// Nuclei in metres, a field at whose centre something is held, a cloud that displacements make of one place.
TEST(SceneChecks, scenes_that_are_finite_where_it_counts_are_read) {
    const std::string begin = "steplab = 1\n[[particles]]\n";
    for (const std::string& scene :
         {begin + "mass = 1.67e-27\n[[particles]]\nmass = 1.67e-27\nposition = [1e-15, 0, 0]\n[[pairs]]\n"
                  "potential = \"-A * exp(-r / a) / r\"\nA = 1e-27\na = 1.4e-15\ncutoff = 5e-15\n",
          begin + "fixed = true\n[[particles]]\nposition = [1, 0, 0]\n[[fields]]\n"
                  "potential = \"-1 / sqrt(x^2 + y^2 + z^2)\"\n",
          begin + "line = { count = 100 }\ndisplacement = { random = 1, seed = 3 }\n"})
        EXPECT_EQ(refusal_of_scene(scene), "read") << scene;
}

// It is there that they start, not where the blocks say.
TEST(SceneChecks, potentials_are_asked_where_a_file_lets_the_particles_start) {
    const auto read = [](const std::string& pair) {
        return describe(scene_from(
            {{.name = "",
              .content =
                  "steplab = 1\n[[particles]]\nline = { count = 2, step = [1, 0, 0] }\n[[pairs]]\npotential = \"" +
                  pair + "\"\n[start]\nfrom = \"a.csv\"\n"},
             {.name = "a.csv", .content = "step,time,particle,x,y,z\n0,0,0,0,0,0\n0,0,1,2,0,0\n"}},
            "a.toml"));
    };
    EXPECT_NO_THROW(read("-log(r - 1.5) + r"));
}

}  // namespace
}  // namespace steplab::test
