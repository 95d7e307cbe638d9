// Whether a particle moves, asked of everything that says so, for every way in which a file can say it.
#include "io/scene_writer.hpp"
#include "io/trajectory_text.hpp"
#include "models/scene/scene_particles.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/act.hpp"
#include "sim/run/linearised.hpp"
#include "sim/run/simulation.hpp"
#include "support/scene_texts.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;

const std::vector<std::string> flags{"", "fixed = true\n", "fixed = false\n"};
const std::vector<std::string> roles{"", "role = \"moving\"\n", "role = \"fixed\"\n", "role = \"kicked\"\n",
                                     "role = \"bullet\"\n"};

/// A stretched spring between a wall and a particle of these keys.
std::string pulled(const std::string& keys, const std::string& fix_keys) {
    const std::string fix = fix_keys.empty() ? "" : "[[fix]]\nparticles = \"ball\"\n" + fix_keys;
    return "steplab = 1\n[[particles]]\ngroup = \"wall\"\nfixed = true\n[[particles]]\ngroup = \"ball\"\n"
           "position = [1, 0, 0]\n" +
           keys + fix + "[[springs]]\npairs = [[\"wall\", \"ball\"]]\nk = 3\nlength = 0.5\n";
}

/// Calls visit(keys, keys of [[fix]]) for every combination that does not contradict itself.
template <class Visit>
void each_combination(const Visit& visit) {
    for (const std::string& flag : flags) {
        for (const std::string& role : roles) {
            for (const std::string& fix_flag : flags) {
                for (const std::string& fix_role : roles) {
                    const std::string keys = flag + role, fix_keys = fix_flag + fix_role;
                    const std::string wrong = "fixed = false\nrole = \"fixed\"\n";
                    if (keys != wrong && fix_keys != wrong) visit(keys, fix_keys);
                }
            }
        }
    }
}

TEST(SceneRoles, are_fixed_where_particles_are_and_nowhere_else) {
    int all = 0, fixed = 0;
    each_combination([&](const std::string& keys, const std::string& fix_keys) {
        SCOPED_TRACE(keys + "then " + fix_keys);
        const RunDescription run = describe(read_scene(pulled(keys, fix_keys)));
        Simulation simulation(run);
        const Vec3 before = simulation.state().displacement.at(1);
        simulation.advance(3);
        const bool moves = simulation.state().displacement.at(1) != before;
        const Shape& shape = *simulation.shape();
        EXPECT_EQ(shape.roles[1] != Role::fixed, moves);
        EXPECT_EQ(shape.roles[0], Role::fixed);
        EXPECT_EQ(acts(Kick{.particle = 1, .velocity = {1, 0, 0}}, shape), moves);
        const LinearisedScene linear(model_of(run).plan(run.scene), shape);
        EXPECT_EQ(linear.size(), moves ? 3 : 0);
        EXPECT_EQ(model_of(run).omega_max(run.scene).value_or(-1) > 0, moves);
        FrameBlock block;
        block.append(simulation.frame(), {.positions = true, .displacements = false}, {}, 0, 2);
        std::string text;
        append_xyz(text, block, {Column::x, Column::y, Column::z});
        EXPECT_EQ(text.ends_with(" fixed\n"), !moves) << text;
        const RunDescription again = describe(read_scene(scene_file_text(run)));
        EXPECT_EQ(model_of(again).shape(again.scene).roles, shape.roles) << "written and read again";
        ++all;
        fixed += moves ? 0 : 1;
    });
    EXPECT_EQ(all, 14 * 14);
    EXPECT_GT(fixed, 40);
}

TEST(SceneRoles, that_contradict_what_is_fixed_are_refused_at_the_role) {
    const std::string wrong = "fixed = false\nrole = \"fixed\"\n";
    EXPECT_THAT(refusal_of_scene(pulled(wrong, "")),
                HasSubstr("a.toml:9:8: a particle of the role \"fixed\" is fixed"));
    EXPECT_THAT(refusal_of_scene(pulled("", wrong)), HasSubstr("a.toml:11:8: a particle of the role \"fixed\""));
}

}  // namespace
}  // namespace steplab::test
