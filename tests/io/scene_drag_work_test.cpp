// The work of drag in scenes that people write.

#include "sim/run/simulation.hpp"
#include "support/runs.hpp"
#include "support/scene_texts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::test {
namespace {

RunDescription dragged(const std::string& text, std::string_view method, double dt) {
    RunDescription run = with_method(describe(read_scene("steplab = 1\n" + text)), method);
    run.precision = Precision::double_;
    run.dt = dt;
    return run;
}

/// Three particles of two masses on springs and a fixed one; `drag` is a table of fields.
std::string four_on_springs(const std::string& drag, const std::string& of_springs = "") {
    return R"(
[[particles]]
group = "wall"
fixed = true
[[particles]]
group = "light"
position = [1, 0, 0]
velocity = [0.5, 0.7, 0]
[[particles]]
group = "heavy"
position = [2, 0.3, 0]
velocity = [0, -0.4, 0.6]
mass = 5
[[particles]]
group = "end"
position = [3, 0, 0]
[[springs]]
pairs = [["wall", "light"], ["light", "heavy"], ["heavy", "end"]]
k = 20
)" + of_springs +
           drag;
}

struct Largest {
    double error = 0, change = 0;
};
/// Over so many steps.
Largest largest(const RunDescription& run, int steps) {
    Simulation counted(run), plain(run);
    EXPECT_TRUE(counted.count_drag_work()) << command_line(run);
    Largest found;
    for (int i = 0; i < steps; ++i) {
        counted.advance(1), plain.advance(1);
        found.error = std::max(found.error, std::abs(counted.energy_error()));
        found.change = std::max(found.change, std::abs(plain.energy_error()));
    }
    EXPECT_EQ(counted.hash(), plain.hash());
    return found;
}

/// Of order 2 at least: those of order 1 are as wrong about the energy itself.
bool is_integrated_in_scenes(const MethodCase& c) {
    return c.info->order_with_drag > 1 && c.precision == Precision::double_ &&
           integrates_drag_work(run_of("rope", c.info->id, c.precision, 0.1));
}

class DragWorkInScenes : public testing::TestWithParam<MethodCase> {};

// The same for all: the layout of few springs between any particles.
TEST_P(DragWorkInScenes, of_drag_in_proportion_to_masses) {
    const std::string drag =
        "[[fields]]\nparticles = [\"light\", \"end\"]\ndrag = 0.2\n[[fields]]\nparticles = \"heavy\"\ndrag = 1.0\n";
    const Largest found = largest(dragged(four_on_springs(drag), GetParam().info->id, 0.005), 400);
    EXPECT_GT(found.change, 0.1);
    EXPECT_LT(found.error, 1e-4 * found.change);  // of order 2: (omega dt)^2 / 8, omega = 6 / s
}

// Of each particle by its own coefficient; where the method does not take that or not count it, nothing is said.
TEST_P(DragWorkInScenes, of_drag_of_each_particle) {
    const std::string drag = "[[fields]]\ndrag = 0.2\n[[fields]]\nparticles = \"heavy\"\ndrag = 1.5\n";
    const RunDescription run = dragged(four_on_springs(drag), GetParam().info->id, 0.005);
    const Method& how = method(run.method);
    ASSERT_EQ(integrates_drag_work(run), how.counts_drag && how.info.order_with_damping > 0);
    if (!integrates_drag_work(run)) return;
    const Largest found = largest(run, 400);
    EXPECT_GT(found.change, 0.1);
    EXPECT_LT(found.error, 1e-4 * found.change);  // as above
}

TEST_P(DragWorkInScenes, of_dashpots_is_not_known) {
    const RunDescription run =
        dragged(four_on_springs("[[fields]]\ndrag = 0.2\n", "damping = 0.1\n"), GetParam().info->id, 0.005);
    EXPECT_FALSE(integrates_drag_work(run));
}

// A pair crosses the cut-off on its way, where steps to a tolerance end.
TEST_P(DragWorkInScenes, of_pairs_with_a_cut_off) {
    const std::string text =
        "[[particles]]\nvelocity = [0.6, 0.1, 0]\n[[particles]]\nposition = [3.5, 0, 0]\nvelocity = [-0.6, 0, 0]\n"
        "[[pairs]]\npotential = \"lennard-jones\"\nepsilon = 1\nsigma = 1\ncutoff = 2.5\n[[fields]]\ndrag = 0.05\n";
    const Largest found = largest(dragged(text, GetParam().info->id, 0.002), 2000);
    EXPECT_GT(found.change, 0.02);
    // of order 2: the energy of Verlet's rule alone is as wrong at the closest approach
    EXPECT_LT(found.error, 5e-3 * found.change);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, DragWorkInScenes, testing::ValuesIn(methods_where(is_integrated_in_scenes)),
                         case_name);

// A step for which no solution is found is taken as two halves: it has their motion, and their work.
TEST(DragWork, of_a_halved_step_is_that_of_its_halves) {
    const std::string text =
        "[[particles]]\nlattice = { kind = \"cubic\", cells = [3, 3, 3], constant = 0.5 }\n"
        "[[particles]]\nposition = [-10, 0, 0]\nvelocity = [1, 0, 0]\n"
        "[[pairs]]\npotential = \"morse\"\nD = 1\nk = 0.5\nr0 = 0.5\n[[fields]]\ndrag = 0.01\n";
    for (const std::string_view id : {"implicit-midpoint", "tr-bdf2", "gauss-16"}) {
        Simulation whole(dragged(text, id, 4)), halves(dragged(text, id, 2));
        ASSERT_TRUE(whole.count_drag_work() && halves.count_drag_work());
        whole.advance(1), halves.advance(2);
        ASSERT_FALSE(whole.divergence() || halves.divergence()) << id;
        // those of gauss-16 begin with other guesses
        EXPECT_LT(distance(whole.frame(), halves.frame()), 1e-13) << id << ": it was halved";
        EXPECT_GT(*halves.drag_work(), 0);
        EXPECT_NEAR(*whole.drag_work(), *halves.drag_work(), 1e-13 * *halves.drag_work()) << id;
    }
}

// Many particles on springs are stepped in an order of their own.
TEST(DragWork, of_particles_in_another_order_is_theirs) {
    const std::string text =
        "[[particles]]\ngroup = \"row\"\nline = { count = 2100, step = [1, 0, 0] }\n"
        "[[particles]]\ngroup = \"heavy\"\nposition = [5, 1, 0]\nmass = 50\nvelocity = [0, 3, 0]\n"
        "[[springs]]\nbetween = \"row\"\nk = 4\n[[springs]]\npairs = [[\"row[5]\", \"heavy\"]]\nk = 10\n"
        "[[fields]]\nparticles = \"row\"\ndrag = 0.1\n[[fields]]\nparticles = \"heavy\"\ndrag = 20\n";
    const Largest found = largest(dragged(text, "dop853", 0.1), 20);
    EXPECT_GT(found.change, 10);
    EXPECT_LT(found.error, 1e-6 * found.change);
}

}  // namespace
}  // namespace steplab::test
