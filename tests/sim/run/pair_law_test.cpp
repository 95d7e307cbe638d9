#include "sim/run/pair_law.hpp"

#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace steplab::test {
namespace {

RunDescription morse(double depth, double k, double r0) {
    RunDescription description = describe("morse");
    description.scene.set("D", depth);
    description.scene.set("k", k);
    description.scene.set("r0", r0);
    return description;
}

TEST(pair_law, is_the_potential_of_the_scene_and_its_slope) {
    const auto laws = pair_laws(morse(2, 3, 1.5));
    ASSERT_EQ(laws.size(), 1u);
    const PairLaw& law = laws.front();
    EXPECT_EQ(law.name, "morse");
    const double b = std::sqrt(3 / (2 * 2.0));
    for (const double r : {0.5, 1.0, 1.5, 2.0, 4.0}) {
        const double e = std::exp(-b * (r - 1.5));
        EXPECT_NEAR(law.energy(r), 2 * ((1 - e) * (1 - e) - 1), 1e-13 * (1 + e * e)) << r;
        // the central difference has an error of h^2 / 6 V''' and rounding
        constexpr double h = 1e-5;
        EXPECT_NEAR(law.force(r), -(law.energy(r + h) - law.energy(r - h)) / (2 * h), 1e-8) << r;
    }
    EXPECT_GT(law.force(1), 0) << "particles nearer than r0 push each other";
}

TEST(pair_law, is_shown_around_its_well) {
    const PairLaw law = pair_laws(morse(2, 3, 1.5)).front();
    EXPECT_LT(law.closest, 1.5);
    EXPECT_GT(law.closest, 0);
    EXPECT_GT(law.farthest, 2 * 1.5);
    EXPECT_GT(law.energy(law.closest), 0) << "the wall can be seen";
}

TEST(pair_law, of_scenes_without_pair_forces_is_none) {
    for (const char* model : {"free", "oscillator", "chain", "mesh"})
        EXPECT_TRUE(pair_laws(describe(model)).empty()) << model;
}

TEST(pair_law, within_a_cut_off_ends_there) {
    const PairLaw law = pair_laws(describe("crystal")).front();
    ASSERT_GT(law.cutoff, 0);
    EXPECT_EQ(law.farthest, law.cutoff);
    EXPECT_EQ(law.energy(law.cutoff), 0);
    EXPECT_NEAR(law.energy(0.999999 * law.cutoff), 0, 1e-9);  // shifted there together with its slope
    EXPECT_LT(law.energy(0.6 * law.cutoff), -1e-6);
}

// In the energy of two particles there is one pair.
TEST(pair_law, agrees_with_the_energy_of_a_run) {
    RunDescription description = morse(1, 0.5, 4);
    description.scene.set("edge", 1);
    Simulation simulation(description);
    simulation.advance(40);
    const PairLaw law = pair_laws(description).front();
    const auto distances = distances_now(law, simulation.frame(), 10);
    ASSERT_EQ(distances.size(), 1u);
    EXPECT_NEAR(law.energy(distances.front()), simulation.diagnostics().potential, 1e-12);
}

TEST(pair_law, distances_are_of_every_pair_once_or_of_a_fair_sample) {
    const RunDescription description = describe("morse");
    Simulation simulation(description);
    const PairLaw law = pair_laws(description).front();
    const std::size_t n = simulation.particles();
    const auto all = distances_now(law, simulation.frame(), 1000000);
    EXPECT_EQ(all.size(), n * (n - 1) / 2);
    EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
    const auto some = distances_now(law, simulation.frame(), 50);
    ASSERT_EQ(some.size(), 50u);
    EXPECT_NEAR(some[25], all[all.size() / 2], 1e-9) << "the median is kept";
    EXPECT_EQ(some.front(), all.front());
}

// Nearest images, within the cut-off alone, of some particles from everywhere.
TEST(pair_law, distances_in_a_large_periodic_scene_are_those_of_neighbours) {
    const RunDescription description = describe("crystal");
    const Simulation simulation(description);
    const PairLaw law = pair_laws(description).front();
    const auto some = distances_now(law, simulation.frame(), 400);
    ASSERT_FALSE(some.empty());
    EXPECT_LE(some.size(), 400u);
    EXPECT_GT(some.front(), 0);
    EXPECT_LT(some.back(), law.cutoff);
}

}  // namespace
}  // namespace steplab::test
