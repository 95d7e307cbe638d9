#include "models/scene/pair_well.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace steplab::test {
namespace {

// The minimum is bisected down to rounding.
constexpr double rounding = 1e-12;

PairTerm morse(double depth, double k, double r0) {
    return {.potential = "morse", .values = {{"D", depth}, {"k", k}, {"r0", r0}}};
}

TEST(PairWell, of_morse_is_at_r0_with_its_force_constant) {
    for (const double scale : {1e-9, 1.0, 1e6}) {
        const auto well = pair_well(morse(2, 50 / scale, 0.7 * scale), {});
        ASSERT_TRUE(well);
        EXPECT_NEAR(well->distance, 0.7 * scale, rounding * scale);
        EXPECT_NEAR(well->stiffness, 50 / scale, 1e-9 * 50 / scale);
    }
}

TEST(PairWell, of_lennard_jones_is_where_the_books_have_it) {
    const auto well = pair_well({.potential = "lennard-jones", .values = {{"epsilon", 3.0}, {"sigma", 0.5}}}, {});
    ASSERT_TRUE(well);
    const double distance = std::pow(2.0, 1.0 / 6) * 0.5;
    EXPECT_NEAR(well->distance, distance, rounding);
    EXPECT_NEAR(well->stiffness, 72 * 3 / (distance * distance), 1e-8);
}

TEST(PairWell, of_an_expression_is_that_of_its_twin) {
    const PairTerm written{.potential = "D*((1 - exp(-b*(r - r0)))^2 - 1)",
                           .values = {{"D", 2.0}, {"b", std::sqrt(50.0 / 4)}, {"r0", 0.7}}};
    const auto well = pair_well(written, {}), twin = pair_well(morse(2, 50, 0.7), {});
    ASSERT_TRUE(well && twin);
    EXPECT_NEAR(well->distance, twin->distance, rounding);
    EXPECT_NEAR(well->stiffness, twin->stiffness, 1e-8);
}

// A cut-off shifts the minimum a little, and beyond it there is none.
TEST(PairWell, is_that_without_a_cutoff) {
    for (const double cutoff : {0.5, 0.7, 0.8, 3.0}) {
        PairTerm term = morse(2, 50, 0.7);
        term.cutoff = cutoff;
        const auto well = pair_well(term, {});
        ASSERT_TRUE(well) << cutoff;
        EXPECT_NEAR(well->distance, 0.7, rounding) << cutoff;
    }
}

TEST(PairWell, is_none_where_particles_only_repel_or_attract_each_other) {
    EXPECT_FALSE(pair_well({.potential = "gravity", .values = {{"G", 1.0}}}, {2, 3, 0, 0}));
    EXPECT_FALSE(pair_well({.potential = "coulomb", .values = {{"K", 1.0}}}, {1, 1, 1, 1}));
    EXPECT_FALSE(pair_well({.potential = "coulomb", .values = {{"K", 1.0}}}, {1, 1, 1, -1}));
    EXPECT_FALSE(pair_well({.potential = "1000 * max(0, 0.2 - r)^2.5"}, {})) << "a contact";
    EXPECT_FALSE(pair_well({.potential = "0"}, {}));
}

TEST(PairWell, of_ions_is_that_of_unlike_charges) {
    const PairTerm salt{.potential = "1000*exp(-r/0.1) + q1*q2/r"};
    EXPECT_FALSE(pair_well(salt, {1, 1, 1, 1}));
    const auto well = pair_well(salt, {1, 1, 1, -1});
    ASSERT_TRUE(well);
    const double r = well->distance;
    EXPECT_NEAR(1e4 * std::exp(-r / 0.1), 1 / (r * r), 1e-9);
    EXPECT_NEAR(well->stiffness, 1e5 * std::exp(-r / 0.1) - 2 / (r * r * r), 1e-8);
}

}  // namespace
}  // namespace steplab::test
