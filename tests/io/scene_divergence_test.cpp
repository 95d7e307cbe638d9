// When runs of scenes with typed potentials count as diverged.

#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace steplab::test {
namespace {

/// Particles at rest where all that is typed is 0.
const std::vector<std::string> at_zero{
    "[[particles]]\n[[particles]]\nposition = [1, 0, 0]\n[[pairs]]\npotential = \"log(r)\"\n",
    "[[particles]]\n[[particles]]\nposition = [1, 0, 0]\n[[pairs]]\npotential = \"1 - 1 / r\"\n",
    "[[particles]]\n[[particles]]\nposition = [0, 0, 1]\n[[pairs]]\npotential = \"10 * (r - 1) - 3 * (r - 1)^2\"\n",
    "[[particles]]\nposition = [1e5, 0, 0]\n[[particles]]\nposition = [1e5, 1e-3, 0]\n[[pairs]]\n"
    "potential = \"1e-6 * log(r / 1e-3)\"\n",
    "[[particles]]\n[[fields]]\npotential = \"9.81 * m * y\"\n",
    "[[particles]]\n[[fields]]\npotential = \"x\"\n",
    "[[particles]]\nposition = [2, 0, 0]\n[[fields]]\npotential = \"x^4 / 4 - x^2\"\n",
    "[[particles]]\nposition = [0, 3, 0]\n[[fields]]\npotential = \"sin(y - 3)\"\n"};

RunDescription run_of_text(const std::string& scene, std::string_view method, double dt, Precision precision) {
    RunDescription run = with_method(describe(read_scene("steplab = 1\n" + scene)), method);
    run.dt = dt;
    run.precision = precision;
    return run;
}

std::string ended(const RunDescription& run, std::uint64_t steps) {
    Simulation simulation(run);
    simulation.advance(steps);
    simulation.conclude();
    return simulation.divergence() ? simulation.divergence()->message : "";
}

TEST(SceneDivergence, is_not_said_of_motion_from_rest_where_a_typed_potential_is_0) {
    for (const std::string& scene : at_zero) {
        for (const char* method : {"rk4", "velocity-verlet", "euler-forward", "euler", "implicit-midpoint"}) {
            for (const Precision precision : precisions)
                EXPECT_EQ(ended(run_of_text(scene, method, 1e-3, precision), 700), "") << method << '\n' << scene;
        }
    }
}

TEST(SceneDivergence, is_said_where_steps_are_too_long_for_a_typed_potential) {
    const std::vector<std::string> stiff{
        "[[particles]]\n[[particles]]\nposition = [1.001, 0, 0]\n[[pairs]]\npotential = \"5000 * (r - 1)^2\"\n",
        "[[particles]]\nposition = [0.001, 0, 0]\n[[fields]]\npotential = \"5000 * x^2\"\n"};
    for (const std::string& scene : stiff) {
        for (const char* method : {"rk4", "velocity-verlet", "euler"})
            EXPECT_NE(ended(run_of_text(scene, method, 0.1, Precision::double_), 512), "") << method << '\n' << scene;
    }
}

// Moved in their box, some particles come to lie on images of others, where a typed potential has no bound.
TEST(SceneDivergence, is_said_of_a_typed_crystal_in_a_box_as_without) {
    const std::string crystal =
        "[[particles]]\nlattice = { kind = \"cubic\", cells = [10, 10, 10], constant = 1.1 }\n"
        "temperature = { kT = 0.1, seed = 5 }\n[[pairs]]\npotential = \"4 * (r^-12 - r^-6)\"\ncutoff = 2.5\n";
    for (const char* const box : {"", "[box]\nsize = [11, 11, 11]\n"})
        EXPECT_NE(ended(run_of_text(crystal + box, "velocity-verlet", 0.05, Precision::double_), 300), "") << box;
}

}  // namespace
}  // namespace steplab::test
