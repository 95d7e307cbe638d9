// What each key of a scene file means, and which values it refuses.
#include "core/error.hpp"
#include "io/scene_toml.hpp"
#include "models/scene/scene_particles.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/run_description.hpp"
#include "sim/run/starting.hpp"
#include "support/scene_texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;

/// A scene of these blocks.
std::string with_blocks(const std::string& blocks) { return "steplab = 1\n" + blocks + "\n"; }
std::string pair_and(const std::string& blocks) {
    return with_blocks("[[particles]]\ngroup = \"pair\"\nline = { count = 2, step = [1, 0, 0] }\n" + blocks);
}
Scene scene_of(const std::string& text) {
    const RunDescription run = describe(read_scene(text));
    return model_of(run).scene(run.scene);
}
/// Where particles start.
std::vector<Vec3> starts_of(const std::string& text) {
    const Scene scene = scene_of(text);
    const SceneParticles particles(scene);
    std::vector<Vec3> all;
    for (std::size_t i = 0; i < particles.count(); ++i)
        all.push_back(particles[i].position + particles[i].displacement);
    return all;
}

TEST(SceneBlocks, refuse_what_makes_no_particles) {
    const std::string one = "[[particles]]\n";
    const std::vector<std::pair<std::string, const char*>> cases{
        {"group = \"-a\"", "the name of a group begins with a letter"},
        {"group = \"2a\"", "the name of a group begins with a letter"},
        {"group = \"a b\"", "the name of a group begins with a letter"},
        {"group = \"all\"", "not \"all\""},
        {"line = { step = [1, 0, 0] }", "a line needs a count"},
        {"line = { count = 0, step = [1, 0, 0] }", "must be an integer from 1"},
        {"line = { count = 4294967296, step = [1, 0, 0] }", "must be an integer from 1 to 4294967295"},
        {"grid = { steps = [[1, 0, 0], [0, 1, 0]] }", "a grid needs a count"},
        {"grid = { count = [2], steps = [[1, 0, 0], [0, 1, 0]] }", "must be two numbers"},
        {"grid = { count = [65536, 65536], steps = [[1, 0, 0], [0, 1, 0]] }", "at most 4294967295 particles"},
        {"lattice = { kind = \"fcc\" }", "a lattice needs cells"},
        {"lattice = { cells = [2, 2, 2], constant = 0 }", "must be > 0"},
        {"lattice = { cells = [2, 2, 2], constant = -1 }", "must be > 0"},
        {"lattice = { kind = \"hcp\", cells = [1, 1, 1] }", "unknown lattice 'hcp'"},
        {"lattice = { kind = \"fcc\", cells = [1024, 1024, 1024] }", "at most 4294967295 particles"},
        {"line = { count = 2, step = [1, 0, 0] }\nlattice = { cells = [1, 1, 1] }", "at most one of"},
        {"displacement = { random = -1 }", "must be >= 0"},
        {"displacement = { random = 1, seed = 0 }", "a seed must be an integer from 1 to 16777215"},
        {"displacement = { random = 1, seed = 16777216 }", "a seed must be an integer from 1 to 16777215"},
        {"temperature = { kT = -1 }", "must be >= 0"},
        {"temperature = { kT = 1, exact = 1 }", "must be true or false"},
        {"role = \"flying\"", "unknown role 'flying'"},
        {"mass = 0", "must be > 0"},
        {"fixed = 1", "must be true or false"}};
    for (const auto& [keys, message] : cases)
        EXPECT_THAT(refusal_of_scene(with_blocks(one + keys)), HasSubstr(message)) << keys;
}

TEST(SceneBlocks, refuse_what_makes_no_forces) {
    const std::string lennard_jones = "[[pairs]]\npotential = \"lennard-jones\"\nepsilon = 1\nsigma = 1\n";
    const std::vector<std::pair<std::string, const char*>> cases{
        {"[[fix]]\nfixed = true", "[[fix]] needs particles"},
        {"[[fix]]\nparticles = []\nfixed = true", "must name at least one particle"},
        {"[[fix]]\nparticles = \"pair[2]\"\nfixed = true", "a.toml:6:13: group 'pair' has no particle 2"},
        {"[[particles]]\ngroup = \"g\"\ngrid = { count = [2, 2], steps = [[1, 0, 0], [0, 1, 0]] }\n[[fix]]\n"
         "particles = \"g[1,]\"\nfixed = true",
         "'g[1,]': two numbers belong into the brackets"},
        {"[[springs]]\nbetween = \"pair\"", "[[springs]] needs k"},
        {"[[springs]]\nbetween = \"pair\"\nk = 1\ndamping = -1", "must be >= 0"},
        {"[[springs]]\nbetween = \"pair\"\nk = 1\nlength = -1", "must be >= 0"},
        {"[[springs]]\nbetween = \"pair\"\nk = 1\nalong = \"rows\"", "unknown direction 'rows'"},
        {"[[springs]]\npairs = [[\"pair[0]\"]]\nk = 1", "a spring joins two particles"},
        {"[[springs]]\npairs = [[\"pair[0]\", \"pair\"]]\nk = 1", "joins single particles"},
        {"[[particles]]\ngroup = \"single\"\n[[springs]]\nbetween = \"single\"\nk = 1", "which has no neighbours"},
        {"[[pairs]]\ncutoff = 2", "[[pairs]] needs a potential"},
        {lennard_jones + "between = [\"pair\", \"pair\", \"pair\"]", "between takes one group or two"},
        {lennard_jones + "between = [\"pair[0]\", \"pair[0]\"]", "within one particle"},
        {lennard_jones + "cutoff = 0", "must be > 0"},
        {"[[pairs]]\npotential = \"moorse\"", "unknown potential 'moorse' (did you mean 'morse'?)"},
        {"[[pairs]]\npotential = \"\"", "unknown potential ''"},
        {"[[pairs]]\npotential = \"-r\"", "read"},
        {"[[pairs]]\npotential = \"pi\"", "read"},
        {"[[pairs]]\npotential = \"lennard-jones\"\nepsilon = 1\nsigma = 0", "sigma must be > 0"},
        {lennard_jones + "cutoff = 4\n[box]\nsize = [0, 9, 9]", "2.3 times the cutoff"},
        {lennard_jones + "cutoff = 4\n[box]\nsize = [0, 9.2, 0]", "read"},
        {lennard_jones + "[box]\nsize = [0, 0, 0]", "read"},
        {"[box]\nsize = [9, 9, -1]", "must be >= 0"},
        {"[[fields]]\nvelocity = 1", "unknown key 'velocity' of [[fields]]"},
        {"[[fields]]\ndrag = -1", "must be >= 0"},
        {"[[fields]]\npotential = \"1 / x\"", "not finite where particle 0 starts, at (0, 0, 0)"},
        {"[[fields]]\npotential = \"sqrt(x)\"", "not finite where particle 0 starts"},  // its force is not
        {"[[fields]]\nparticles = \"pair[1]\"\npotential = \"1 / x\"", "read"},
        {"[[fix]]\nparticles = \"pair[1]\"\ndisplacement = [-1, 0, 0]\n[[fields]]\nparticles = \"pair[1]\"\n"
         "potential = \"1 / x\"",
         "not finite where particle 1 starts, at (0, 0, 0)"},
        {"[[fields]]\npotential = \"a x\"\na = 1", "a.toml:6"}};
    for (const auto& [blocks, message] : cases)
        EXPECT_THAT(refusal_of_scene(pair_and(blocks)), HasSubstr(message)) << blocks;
}

TEST(SceneBlocks, refuse_what_is_no_parameter) {
    std::string chain = "p0 = 1\n";
    for (int i = 1; i <= 300; ++i) chain += "p" + std::to_string(i) + " = \"p" + std::to_string(i - 1) + "\"\n";
    const std::vector<std::pair<std::string, const char*>> cases{
        {"k = 1\npi = 3", "'pi' cannot be a name in expressions"},
        {"k = 1\n\"a-b\" = 3", "cannot be a name in expressions"},
        {"k = { range = [1, 2] }", "parameter 'k' needs a value"},
        {"k = { value = 1, range = [2, 1] }", "the range must grow"},
        {"k = { value = 1, range = [1, 1] }", "the range must grow"},
        {"k = { value = 1, range = [1, \"k\"] }", "a.toml:9:26: the range must grow"},
        {"k = { value = 1, range = [0, 2], logarithmic = true }", "a logarithmic range of 'k' must begin above 0"},
        {"k = { value = 0, logarithmic = true }", "a.toml:9:32: 'k' is not above 0: it needs a range that is"},
        {"k = inf", "must be a finite number"},
        {"k = \"1 / 0\"", "its value is not finite"},
        {"k = \"1 +\"", "\"1 +\", character 4"},
        {chain + "k = \"p300\"", "follows a chain of more than 200 others"}};
    for (const auto& [parameters, message] : cases)
        EXPECT_THAT(
            refusal_of_scene(pair_and("[[springs]]\nbetween = \"pair\"\nk = \"k\"\n[parameters]\n" + parameters)),
            HasSubstr(message))
            << parameters;
}

TEST(SceneBlocks, arrange_particles_in_rows_and_cells) {
    const std::string grid = "[[particles]]\ngrid = { count = [2, 3], steps = [[1, 0, 0], [0, 10, 0]] }";
    EXPECT_EQ(starts_of(with_blocks(grid)),
              (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 10, 0}, {1, 10, 0}, {0, 20, 0}, {1, 20, 0}}));
    const auto lattice = [](const char* kind) {
        return starts_of(with_blocks("[[particles]]\nposition = [1, 0, 0]\nlattice = { kind = \"" + std::string(kind) +
                                     "\", cells = [1, 1, 2], constant = 2 }"));
    };
    EXPECT_EQ(lattice("cubic"), (std::vector<Vec3>{{1, 0, 0}, {1, 0, 2}}));
    EXPECT_THAT(lattice("bcc"),
                testing::UnorderedElementsAre(Vec3{1, 0, 0}, Vec3{2, 1, 1}, Vec3{1, 0, 2}, Vec3{2, 1, 3}));
    EXPECT_THAT(lattice("fcc"),
                testing::UnorderedElementsAre(Vec3{1, 0, 0}, Vec3{2, 1, 0}, Vec3{2, 0, 1}, Vec3{1, 1, 1}, Vec3{1, 0, 2},
                                              Vec3{2, 1, 2}, Vec3{2, 0, 3}, Vec3{1, 1, 3}));
}

TEST(SceneBlocks, springs_go_along_axes_diagonals_or_both) {
    using Along = SpringTerm::Along;
    for (const auto& [word, along] :
         {std::pair{"axes", Along::axes}, std::pair{"diagonals", Along::diagonals}, std::pair{"both", Along::both}}) {
        const Scene scene = scene_of(with_blocks(
            "[[particles]]\ngroup = \"net\"\ngrid = { count = [2, 2], steps = [[1, 0, 0], [0, 1, 0]] }\n[[springs]]\n"
            "between = \"net\"\nk = 1\nalong = \"" +
            std::string(word) + "\""));
        EXPECT_EQ(scene.springs[0].along, along) << word;
    }
}

TEST(SceneBlocks, take_the_first_of_several_problems_wherever_it_is_read) {
    const std::string text = pair_and("[[fields]]\ndrag = -1\n[[springs]]\nbetween = \"pair\"");
    EXPECT_THAT(refusal_of_scene(text), HasSubstr("a.toml:6:8: must be >= 0")) << "springs are read before fields";
}

TEST(SceneBlocks, values_of_a_temperature_are_what_is_written) {
    const auto temperature = [](const std::string& keys) {
        return *scene_of(pair_and("temperature = { kT = 1" + keys + " }")).particles[0].temperature;
    };
    EXPECT_TRUE(temperature("").exact);
    EXPECT_TRUE(temperature(", exact = true").exact);
    EXPECT_FALSE(temperature(", exact = false").exact);
    EXPECT_EQ(temperature(", seed = 16777215").seed, 16777215u);
}

TEST(SceneBlocks, sliders_without_a_range_reach_from_0_to_twice_the_value) {
    const auto slider = [](const std::string& value) {
        const SceneOrigin scene =
            read_scene(pair_and("[[springs]]\nbetween = \"pair\"\nk = \"k + 9\"\n[parameters]\nk = " + value));
        const ParameterInfo info = describe(scene).scene.infos()[0];
        return std::pair(info.slider_low, info.slider_high);
    };
    EXPECT_EQ(slider("3"), std::pair(0.0, 6.0));
    EXPECT_EQ(slider("-3"), std::pair(-6.0, 0.0));
    EXPECT_EQ(slider("0"), std::pair(0.0, 1.0));
    EXPECT_EQ(slider("{ value = 3, range = [-1, 4] }"), std::pair(-1.0, 4.0));
    EXPECT_EQ(slider("{ value = 3, range = [\"1\", \"2 * k + pi - pi\"] }"), std::pair(1.0, 6.0));
    EXPECT_EQ(slider("{ value = 3, logarithmic = true }"), std::pair(0.03, 300.0));
    EXPECT_EQ(slider("{ value = 3, range = [1, 9], logarithmic = true }"), std::pair(1.0, 9.0));
}

// A number that the start needs restarts the run, however many parameters lie between.
TEST(SceneBlocks, what_the_start_depends_on_restarts) {
    const auto change = [](const std::string& start, const std::string& force) {
        const SceneOrigin scene =
            read_scene(with_blocks("[parameters]\na = 1\nb = \"a\"\nc = \"b\"\n[[particles]]\ngroup = \"pair\"\nline = "
                                   "{ count = 2, step = [\"" +
                                   start + "\", 0, 0] }\n[[springs]]\nbetween = \"pair\"\nk = \"" + force + " + c\""));
        return describe(scene).scene.infos()[0].on_change;
    };
    EXPECT_EQ(change("1", "a"), OnChange::applies_live);
    EXPECT_EQ(change("a", "1"), OnChange::restarts);
    EXPECT_EQ(change("c", "1"), OnChange::restarts) << "through b";
    EXPECT_EQ(change("c", "a"), OnChange::restarts) << "used by both";
}

TEST(SceneBlocks, what_the_box_depends_on_restarts_though_forces_use_it_first) {
    const SceneOrigin scene = read_scene(
        pair_and("[[springs]]\nbetween = \"pair\"\nk = \"a\"\n[box]\nsize = [\"a\", 0, 0]\n[parameters]\na = 9"));
    EXPECT_EQ(describe(scene).scene.infos()[0].on_change, OnChange::restarts);
}

// Only a chain is limited, not how many parameters follow others.
TEST(SceneBlocks, many_parameters_may_follow_one) {
    std::string parameters = "[parameters]\na = 1\n", sum = "a";
    for (int i = 0; i < 250; ++i) {
        parameters += "b" + std::to_string(i) + " = \"a\"\n";
        sum += " + b" + std::to_string(i);
    }
    EXPECT_EQ(
        scene_of(pair_and("[[springs]]\nbetween = \"pair\"\nk = \"" + sum + "\"\n" + parameters)).springs[0].k.value,
        251);
}

TEST(SceneBlocks, every_character_of_a_text_is_written_so_that_it_is_read_again) {
    std::string text;
    for (int c = 1; c < 128; ++c) text += static_cast<char>(c);
    const toml::table read = toml::parse("a = " + toml_string(text));
    EXPECT_EQ(read["a"].value<std::string>(), text);
}

TEST(SceneBlocks, a_box_has_its_corner) {
    const Scene scene = scene_of(pair_and("[box]\nsize = [9, 8, 7]\ncorner = [-1, -2, -3]"));
    EXPECT_EQ(scene.box.value(), (Vec3{9, 8, 7}));
    ASSERT_TRUE(scene.corner);
    EXPECT_EQ(scene.corner->value(), (Vec3{-1, -2, -3}));
}

/// The first block of a scene whose particles stand in a file: with the columns role and mass, all of mass 2.
ParticleBlock block_of_a_file(const std::string& more) {
    const std::string file =
        "2\nProperties=species:S:1:pos:R:3:role:S:1:masses:R:1\nX 0 0 0 bullet 2\nX 1 0 0 fixed 2\n";
    const RunDescription run =
        describe(scene_from({{.name = "", .content = with_blocks("[[particles]]\nfile = \"a.xyz\"\n" + more)},
                             {.name = "a.xyz", .content = file}},
                            "a.toml"));
    return model_of(run).scene(run.scene).particles.front();
}

TEST(SceneBlocks, of_a_file_refuse_roles_that_there_are_not) {
    const auto read = [](const std::string& column) {
        const std::string scene = with_blocks("[[particles]]\nfile = \"a.xyz\"\n"),
                          file = "1\nProperties=species:S:1:pos:R:3:" + column + ":S:1\nX 0 0 0 flying\n";
        scene_from({{.name = "", .content = scene}, {.name = "a.xyz", .content = file}}, "a.toml");
    };
    EXPECT_NO_THROW(read("type")) << "elsewhere it is anything";
    try {
        read("role");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("unknown role 'flying'; known: moving, fixed, kicked, bullet"));
    }
}

TEST(SceneBlocks, of_a_file_have_its_roles_unless_the_block_gives_one) {
    for (const auto& [more, roles] : {std::pair{"", true}, {"role = \"kicked\"", false}, {"fixed = false", false}})
        EXPECT_EQ(std::get<ListedParticles>(block_of_a_file(more).arrangement).roles, roles) << more;
}

// So that what is drawn from one mass, a temperature, can be given.
TEST(SceneBlocks, of_a_file_of_equal_masses_have_one_mass) {
    for (const auto& [more, mass] : {std::pair{"", 2.0}, {"mass = 5", 5.0}, {"temperature = { kT = 1 }", 2.0}}) {
        const ParticleBlock block = block_of_a_file(more);
        EXPECT_FALSE(std::get<ListedParticles>(block.arrangement).masses) << more;
        EXPECT_EQ(block.mass.value, mass) << more;
    }
}

TEST(SceneBlocks, versions_are_whole_numbers) {
    for (const char* version : {"0", "2", "1.0", "\"1\"", "-1"})
        EXPECT_THAT(refusal_of_scene("steplab = " + std::string(version) + "\n"),
                    HasSubstr("this program reads version 1"))
            << version;
}

}  // namespace
}  // namespace steplab::test
