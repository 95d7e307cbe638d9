#include "io/scene_file.hpp"
#include "io/scene_writer.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace steplab::test {
namespace {

RunDescription read(const std::string& text) { return describe(scene_from({{.name = "", .content = text}}, "a.toml")); }

RunDescription altered(const RunDescription& run) {
    const std::vector<Alteration> alterations{
        {4, true}, {5, std::nullopt, 2.5}, {6, std::nullopt, 2.5}, {7, false, 0.3}};
    return with_alterations(run, alterations);
}

std::string hash_of(const RunDescription& run) {
    Simulation simulation(run);
    simulation.advance(50);
    return simulation.hash();
}

// The scene file of an altered scene is that scene: the same bits from the start.
TEST(AlteredScene, is_saved_as_it_is) {
    for (const char* model : {"chain", "mesh", "morse", "rope"}) {
        const RunDescription run = small_run_of(model, "velocity-verlet", Precision::double_, 0.01);
        EXPECT_EQ(hash_of(read(scene_file_text(altered(run)))), hash_of(altered(run))) << model;
        EXPECT_NE(hash_of(run), hash_of(altered(run))) << model;
    }
}

TEST(AlteredScene, of_a_file_begins_in_the_normal_mode_that_it_has) {
    const std::string file =
        "steplab = 1\ntitle = \"t\"\nteaches = \"t\"\n[[particles]]\ngroup = \"g\"\nline = { count = 9, step = [1, 0, "
        "0] }\n"
        "[[fix]]\nparticles = [\"g[0]\"]\nfixed = true\n[[springs]]\nbetween = \"g\"\nk = 3\n"
        "[start]\nmode = 2\namplitude = 0.1\n[run]\nmethod = \"velocity-verlet\"\ndt = 0.01\n";
    const RunDescription run = altered(read(file));
    EXPECT_EQ(hash_of(read(scene_file_text(run))), hash_of(run));
    EXPECT_NE(hash_of(read(file)), hash_of(run));
}

}  // namespace
}  // namespace steplab::test
