#include "io/scene_file.hpp"

#include "core/error.hpp"
#include "io/files.hpp"
#include "io/scene_writer.hpp"
#include "models/scene/scene.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"
#include "support/scene_texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string rope = R"(steplab = 1
title = "A rope"

[parameters]
k = { value = 200, range = [10, 1e4], unit = "N/m", what = "stiffness", logarithmic = true }
n = 10
g = "k / 20"

[[particles]]
group = "rope"
line = { count = "n", step = [0.5, 0, 0] }

[[fix]]
particles = "rope[0]"
fixed = true

[[springs]]
between = "rope"
k = "2 * k"

[[fields]]
gravity = [0, "-g", 0]
)";

/// Its g under the name of a parameter that some methods have.
const std::string tolerant = replaced(replaced(rope, "g = \"k", "tolerance = \"k"), "\"-g\"", "\"-tolerance\"");

TEST(SceneFile, makes_a_scene_of_its_parameters) {
    const RunDescription run = describe(read_scene(rope));
    ASSERT_EQ(run.scene.infos().size(), 2u) << "one that follows others is no parameter of the scene";
    EXPECT_EQ(run.scene["k"], 200);
    EXPECT_EQ(run.scene.infos()[0].on_change, OnChange::applies_live);
    EXPECT_EQ(run.scene.infos()[0].slider_high, 1e4);
    EXPECT_EQ(run.scene.infos()[1].on_change, OnChange::restarts) << "of a count";
    RunDescription other = run;
    other.scene.set("n", 4);
    other.scene.set("k", 20);
    const Plan plan = model_of(other).plan(other.scene);
    const auto* const line = std::get_if<LineForces>(&plan.forces);
    ASSERT_TRUE(line);
    EXPECT_EQ(line->count, 4u);
    EXPECT_EQ(line->k, 40);
    EXPECT_EQ(line->gravity, 1);
    EXPECT_TRUE(line->first_fixed);
}

TEST(SceneFile, is_compared_by_content) {
    const RunDescription a = describe(read_scene(rope)), b = describe(read_scene(rope)),
                         c = describe(read_scene(rope + "\n"));
    EXPECT_EQ(a, b);
    EXPECT_NE(a, c);
    EXPECT_NE(a, describe("rope"));
}

TEST(SceneFile, says_how_it_opens) {
    const RunDescription run =
        describe(read_scene(rope + "[run]\nmethod = \"verlet\"\ndt = 0.01\nprecision = \"float\"\n"));
    EXPECT_EQ(run.method, "verlet");
    EXPECT_EQ(run.dt, 0.01);
    EXPECT_EQ(run.precision, Precision::float_);
}

// A slider may ask for what cannot be.
TEST(SceneFile, refuses_values_that_make_no_scene_and_has_no_facts_of_them) {
    RunDescription run = describe(read_scene(rope + "[[particles]]\nmass = \"300 - k\"\n"));
    EXPECT_NO_THROW(check(run));
    run.scene.set("k", 301);
    EXPECT_NO_THROW(facts_of(run));
    try {
        check(run);
        ADD_FAILURE();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("must be > 0 (is -1)"));
    }
}

TEST(SceneFile, that_is_wrong_is_refused_with_line_and_column) {
    const std::vector<std::pair<std::string, const char*>> cases{
        {"", "a.toml:1:1: a scene file begins with its version"},
        {"steplab = 2\n", "a.toml:1:11: this program reads version 1"},
        {"steplab = 1\nx = [", "a.toml:2:6: "},
        {"steplab = 1\n", "a scene needs [[particles]]"},
        {replaced(rope, "title", "tittle"), "a.toml:2:1: unknown key 'tittle' of a scene file (did you mean 'title'?)"},
        {replaced(rope, "\"2 * k\"", "\"2 * q\""), "a.toml:19:5: unknown parameter 'q'; known: g, k, n"},
        {replaced(rope, "\"2 * k\"", "\"2 *\""), "a.toml:19:5: \"2 *\", character 4: ends where"},
        {replaced(rope, "\"2 * k\"", "nan"), "a.toml:19:5: must be a finite number"},
        {replaced(rope, "\"2 * k\"", "-1"), "a.toml:19:5: must be >= 0"},
        {replaced(rope, "\"2 * k\"", "[1]"), "a.toml:19:5: must be a number, or an expression"},
        {replaced(rope, "between = \"rope\"", "between = \"roop\""),
         "a.toml:18:11: unknown group 'roop' (did you mean"},
        {replaced(rope, "rope[0]", "rope[10]"), "a.toml:14:13: group 'rope' has no particle 10"},
        {replaced(rope, "\"n\"", "\"n + 0.5\""), "must be an integer from 1 to 4294967295 (is 10.5)"},
        {replaced(rope, "\"n\"", "1000000000000"), "must be an integer from 1"},
        {replaced(rope, "k / 20", "g / 20"), "'g' depends on itself"},
        {replaced(rope, "\"k / 20\"", "10"), "read"},
        {replaced(rope, "[parameters]\n", "[parameters]\nunused = 1\na = \"b\"\nb = \"a\"\n"), "depends on itself"},
        {replaced(rope, "[parameters]\n", "[parameters]\nunused = 1\na = \"zz\"\n"), "unknown parameter 'zz'"},
        {replaced(rope, "[parameters]\n", "[parameters]\nunused = 1\na = \"k\"\n"),
         "nothing uses the parameter 'unused'"},
        {rope + "[run]\ndt = \"1 / k\"\n", "dt and until follow no parameters"},
        {rope + "[run]\nuntil = \"k\"\n", "dt and until follow no parameters"},
        {rope + "[run]\ndt = \"1 / 60\"\nuntil = \"2 * pi\"\n", "read"},
        {rope + "[[particles]]\nmass = 1e-310\n", "must be at least 2.3e-308 (is 1e-310)"},
        {rope + "[[particles]]\nmass = 2.3e-308\n", "read"},
        {replaced(rope, "\"-g\"", "-9.81"), "a.toml:7:5: nothing uses the parameter 'g'"},
        {replaced(rope, "range = [10, 1e4]", "range = [0, 1e4]"), "must begin above 0"},
        {tolerant + "[run]\nmethod = \"dopri5\"\n", "a.toml:7:13: 'tolerance' is a parameter of the method dopri5 too"},
        {tolerant + "[run]\nmethod = \"rk4\"\n", "read"},
        {rope + "[[particles]]\nmass = 0\n", "must be > 0"},
        {rope + "[run]\nmethod = \"rk5\"\n", "a.toml:24:10: unknown method 'rk5' (did you mean 'rk4'?)"},
        {rope + "[[particles]]\ngroup = \"rope\"\n", "there is a group 'rope' already"},
        {rope + "[[springs]]\npairs = [[\"rope[1]\", \"rope[1]\"]]\nk = 1\n", "to itself"},
        {rope + "[[springs]]\npairs = [[\"rope\", \"rope[1]\"]]\nk = 1\n", "joins single particles"},
        {rope + "[[springs]]\nk = 1\n", "needs between or pairs"},
        {rope + "[[pairs]]\npotential = \"mors\"\n", "unknown potential 'mors' (did you mean 'morse'?)"},
        {rope + "[[pairs]]\npotential = \"morse\"\nD = 1\n", "the potential morse needs a value of k"},
        {rope + "[[pairs]]\npotential = \"gravity\"\nG = 1\nK = 1\n", "unknown value 'K' of gravity"},
        {rope + "[[pairs]]\nbetween = \"rope[0]\"\npotential = \"gravity\"\nG = 1\n", "within one particle"},
        {rope + "[[pairs]]\npotential = \"gravity\"\nG = 1\n[box]\nsize = [9, 9, 9]\n", "needs a cutoff"},
        {rope + "[[pairs]]\npotential = \"gravity\"\nG = 1\ncutoff = 4\n[box]\nsize = [9, 9, 9]\n", "2.3 times"},
    };
    for (const auto& [text, message] : cases) EXPECT_THAT(refusal_of_scene(text), HasSubstr(message)) << text;
}

TEST(SceneFile, names_the_first_of_several_problems) {
    const std::string text = replaced(replaced(rope, "\"2 * k\"", "\"2 *\""), "step = [0.5, 0, 0]", "step = [0.5, 0]");
    EXPECT_THAT(refusal_of_scene(text), StartsWith("a.toml:11:30: must be three numbers"));
}

TEST(SceneFile, that_is_none_is_named) {
    const TemporaryFolder folder;
    const auto message = [](const std::string& name) -> std::string {
        try {
            find_scene(name);
            return "found";
        } catch (const Error& error) {
            return error.what();
        }
    };
    EXPECT_THAT(message(folder.file("none.toml")), HasSubstr("there is no such file"));
    EXPECT_THAT(message(folder.path() + "/"), HasSubstr("it is not a file"));
    EXPECT_THAT(message("/dev/zero"), HasSubstr("it is not a file"));
    EXPECT_THAT(message("three-pendulms"), HasSubstr("did you mean 'three-pendulums'?"));
}

TEST(SceneFile, written_again_is_the_same_scene) {
    const RunDescription once = describe(read_scene(rope)), again = describe(read_scene(scene_file_text(once)));
    EXPECT_EQ(model_of(once).scene(once.scene), model_of(again).scene(again.scene));
}

}  // namespace
}  // namespace steplab::test
