#include "models/forces/layouts.hpp"
#include "models/scene/composer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace steplab {
namespace {

using PairList = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

template <class Force>
PairList passing(Force force, const Field<double>& from, const Field<double>& to) {
    PairList found;
    force.passing_pairs(from, to, [&](std::uint32_t i, std::uint32_t j) { found.emplace_back(i, j); });
    std::sort(found.begin(), found.end());
    return found;
}

const LineForces line{.count = 20, .rest_length = 1};
const GridForces grid{.rows = 5, .columns = 5, .rest_length = 1};
const PairForces pairs{.count = 20};

TEST(PassingPairs, of_a_line_are_neighbours_that_change_places) {
    Field<double> from(20), to(20);
    to.set(7, {1.5, 0, 0});  // behind particle 8, whose rest position is 1 away
    EXPECT_EQ(passing(Line<double>(line), from, to), (PairList{{7, 8}}));
    EXPECT_DOUBLE_EQ(Line<double>(line).separation(to, 7, 8).x, -0.5);
    EXPECT_DOUBLE_EQ(Line<double>(line).separation(to, 8, 7).x, 0.5);
}

TEST(PassingPairs, are_none_where_no_spring_reverses_or_no_force_jumps) {
    Field<double> from(20), to(20);
    to.set(7, {0.9, 0, 0});
    EXPECT_EQ(passing(Line<double>(line), from, to), PairList{});
    LineForces without_length = line;
    without_length.rest_length = 0;
    from.set(7, {-0.1, 0, 0});  // through particle 8, but the force of such a spring is smooth there
    EXPECT_EQ(passing(Line<double>(without_length), from, to), PairList{});
}

TEST(PassingPairs, of_a_grid_are_springs_that_reverse) {
    Field<double> from(25), to(25);
    to.set(12, {1.5, 0, 0});  // the centre beyond its neighbour to the east, and past the two on the diagonals
    const Grid<double> engine(grid);
    PairList expected;
    for (const std::uint32_t other : {6u, 7u, 8u, 11u, 13u, 16u, 17u, 18u}) {
        const auto a = engine.separation(from, 12, other), b = engine.separation(to, 12, other);
        if (!(a.x * b.x + a.y * b.y + a.z * b.z > 0)) expected.emplace_back(std::min(12u, other), std::max(12u, other));
    }
    EXPECT_EQ(expected, (PairList{{12, 13}}));
    EXPECT_EQ(passing(engine, from, to), expected);
}

TEST(PassingPairs, of_a_grid_do_not_join_the_end_of_a_row_to_another_row) {
    Field<double> from(25), to(25);
    to.set(14, {2.5, 0, 0});  // the end of row 2, far beyond where row 3 begins: none of its own springs reverses
    EXPECT_EQ(passing(Grid<double>(grid), from, to), PairList{});
}

TEST(PassingPairs, of_pairs_are_any_two_within_reach) {
    Field<double> from(20), to(20);
    for (std::size_t i = 0; i < 20; ++i) from.set(i, {0.4 * static_cast<double>(i), 0, 0});
    to = from;
    std::swap(to.x()[3], to.x()[4]);
    EXPECT_EQ(passing(Pairs<double>(pairs), from, to), (PairList{{3, 4}}));
    NearPairForces near{pairs};
    EXPECT_EQ(passing(NearPairs<double>(near), from, to), (PairList{{3, 4}}));
    near.cutoff = 0.2;
    EXPECT_EQ(passing(NearPairs<double>(near), from, to), PairList{});
}

/// The pairs of two particles that change places, of a potential between all.
PairList passing_of(ComposedPairs between) {
    between.first = {0, 1};
    auto terms = std::make_shared<Composition>();
    terms->count = 2;
    terms->pairs = {std::move(between)};
    Field<double> from(2), to(2);
    from.set(1, {0.5, 0, 0}), to.set(1, {-0.5, 0.1, 0});
    return passing(Composed<double>(ComposedForces{2, 1, terms}), from, to);
}
ComposedPairs built_in(const std::string& potential, std::vector<double> values, double cutoff = 0) {
    ComposedPairs term;
    term.potential = potential;
    term.values = std::move(values);
    term.cutoff = cutoff;
    return term;
}
ComposedPairs typed(const std::string& potential, std::optional<double> cutoff = {}) {
    PairTerm term{.potential = potential};
    if (cutoff) term.cutoff = *cutoff;
    return pair_force_of(term, 1);
}

// A force that goes to zero smoothly where two particles meet goes on beyond.
TEST(PassingPairs, of_composed_scenes_are_those_whose_force_jumps_where_they_meet) {
    const PairList both{{0, 1}};
    EXPECT_EQ(passing_of(built_in("gravity", {1, 0})), both);
    EXPECT_EQ(passing_of(built_in("gravity", {1, 0.1})), PairList{});
    EXPECT_EQ(passing_of(built_in("coulomb", {1, 0.1})), PairList{});
    EXPECT_EQ(passing_of(built_in("gravity", {1, 0.1}, 2)), both) << "the shift has a direction";
    EXPECT_EQ(passing_of(built_in("morse", {1, 1, 1})), both);
    EXPECT_EQ(passing_of(built_in("lennard-jones", {1, 1})), both);
    for (const char* const smooth : {"exp(-r^2)", "3*r^2", "-1/(1 + r^2)", "log(1 + r^4)"}) {
        EXPECT_EQ(passing_of(typed(smooth)), PairList{}) << smooth;
        EXPECT_EQ(passing_of(typed(smooth, 2)), both) << smooth;
    }
    for (const char* const jumping : {"r", "(r - 1)^2", "exp(-r)", "1/r^2", "abs(r^2 - 1)", "log(r)", "r^3", "r^1.5"})
        EXPECT_EQ(passing_of(typed(jumping)), both) << jumping;
}

}  // namespace
}  // namespace steplab
