#include "models/forces/layouts.hpp"
#include "models/scene/potential_expression.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

// How Composed sums in float and double: springs in rows, pairs by clusters, by several threads.

template <class T>
class ComposedSums : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(ComposedSums, Numbers);

template <class T>
Field<T> near_a_lattice(std::size_t side, double step, double shift) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-shift, shift);
    Field<T> field(side * side * side);
    for (std::size_t i = 0; i < field.count(); ++i) {
        const auto at = [&](std::size_t place) { return step * static_cast<double>(place) + uniform(random); };
        field.set(i, {at(i % side), at(i / side % side), at(i / side / side)});
    }
    return field;
}

ComposedForces forces_of(const Composition& terms, std::size_t threads = 1) {
    return {terms.count, terms.mass, std::make_shared<const Composition>(terms), threads};
}

void give_masses_and_fix_some(Composition& terms) {
    terms.mass = 2;
    for (std::size_t i = 0; i < terms.count; ++i) {
        terms.masses.push_back(1 + 0.125 * static_cast<double>(i % 5));
        terms.fixed.push_back(i % 11 == 0 ? 1 : 0);
        terms.accelerations.push_back({0.1, -9.81, static_cast<double>(i % 3)});
    }
}

/// Springs between random particles, some with numbers of their own and some without length.
Composition network(std::size_t count, bool uniform) {
    Composition terms;
    terms.count = count;
    std::mt19937 random(3);
    const auto any = [&](std::size_t below) { return static_cast<std::uint32_t>(random() % below); };
    for (std::size_t i = 0; i < count; ++i) terms.reference.push_back({0.5 * any(64), 0.5 * any(64), 0.25 * any(64)});
    for (std::size_t s = 0; s < 3 * count; ++s) {
        const std::uint32_t first = any(count), second = any(count);
        if (first == second) continue;
        const Vec3 rest = terms.reference[second] - terms.reference[first];
        ComposedSpring spring{.first = first, .second = second, .rest = rest, .length = length(rest), .k = 3};
        if (!uniform && s % 3 == 0) spring.k = 5, spring.length = 0, spring.stretch = dot(rest, rest);
        if (!uniform && s % 5 == 0) spring.quadratic = 0.5, spring.cubic = 0.25;
        terms.springs.push_back(spring);
    }
    return terms;
}

template <class T>
Field<T> summed_one_by_one(const Composition& terms, const Field<T>& u) {
    const ComposedParticles<T> particles(std::make_shared<const Composition>(terms));
    Field<T> a(terms.count);
    for (std::size_t i = 0; i < terms.accelerations.size(); ++i) a.set(i, terms.accelerations[i]);
    ComposedSprings<T>(terms).add(particles, u, a);
    for (std::size_t i = 0; i < terms.fixed.size(); ++i) {
        if (terms.fixed[i] != 0) a.set(i, {});
    }
    return a;
}

template <class T>
Field<T> sums(Composed<T>& force, const Field<T>& u) {
    Field<T> a(u.count());
    force.accelerations(u, a);
    return a;
}

template <class T>
Field<T> handed_out(Composed<T>& force, const Field<T>& u) {
    Field<T> a(u.count());
    force.each_acceleration(u, [to = FieldLanes<T>(a)](std::size_t r, const auto& of) { to.set(r, of); });
    return a;
}

template <class T>
void expect_same(const Field<T>& a, const Field<T>& b, const std::string& what) {
    for (std::size_t i = 0; i < a.count(); ++i) ASSERT_EQ(a.at(i), b.at(i)) << what << ", particle " << i;
}

// Every sum has its terms in the order of the springs: to the last bit.
TYPED_TEST(ComposedSums, springs_in_rows_are_those_added_one_by_one) {
    for (const std::size_t count : {3U, 37U, 500U}) {
        for (const bool uniform : {true, false}) {
            for (const Vec3 box : {Vec3{}, Vec3{9, 0, 7}}) {
                Composition terms = network(count, uniform);
                terms.box = box;
                if (box != Vec3{}) terms.reference.clear();
                if (!uniform) give_masses_and_fix_some(terms);
                Field<TypeParam> u = near_a_lattice<TypeParam>(8, 0.5, 0.2);
                Field<TypeParam> some(count);
                copy(u, 0, count, some, 0);
                const auto expected = summed_one_by_one(terms, some);
                ASSERT_TRUE(SpringRows<TypeParam>::of(terms));
                for (const std::size_t threads : {1U, 3U}) {
                    Composed<TypeParam> force(forces_of(terms, threads));
                    expect_same(sums(force, some), expected, "sums");
                    expect_same(handed_out(force, some), expected, "handed out");
                }
            }
        }
    }
}

// Beside a particle with many springs, all lanes but one stay empty: rows of more than two are no gain. The sums are
// the same.
TYPED_TEST(ComposedSums, a_star_of_springs_is_not_put_in_rows) {
    Composition terms;
    terms.count = 400;
    for (std::uint32_t i = 1; i < 400; ++i) terms.springs.push_back({.first = 0, .second = i, .length = 1, .k = 1});
    EXPECT_EQ(SpringRows<TypeParam>::of(terms).has_value(), Lanes<TypeParam>::count <= 2);
    const Field<TypeParam> all = near_a_lattice<TypeParam>(8, 0.5, 0.2);
    Field<TypeParam> u(400);
    copy(all, 0, 400, u, 0);
    Composed<TypeParam> force(forces_of(terms));
    expect_same(sums(force, u), summed_one_by_one(terms, u), "sums");
}

/// Of one set, or of two of which the second is not smaller.
ComposedPairs pairs_without_cutoff(const std::string& potential, std::size_t first, std::size_t second) {
    ComposedPairs pairs;
    pairs.potential = potential == "gravity" ? potential : "";
    if (potential == "gravity") pairs.values = {3, 0};
    if (potential != "gravity") pairs.expression = expression_of(PairTerm{.potential = potential}, 2);
    pairs.first.resize(first), pairs.second.resize(second);
    std::iota(pairs.first.begin(), pairs.first.end(), 0U);
    std::iota(pairs.second.begin(), pairs.second.end(), static_cast<std::uint32_t>(first));
    return pairs;
}

template <class T>
void add_row_by_row(const ComposedPairs& pairs, const ComposedParticles<T>& particles, const Field<T>& u, Field<T>& a) {
    const PairPotential<T> potential(pairs, particles.terms().mass);
    const auto vector = [](const Field<T>& field, std::size_t i) {
        return Vector<T>{field.x()[i], field.y()[i], field.z()[i]};
    };
    const auto add = [&](std::size_t i, const Vector<T>& push) {
        const Vector<T> sum = vector(a, i) + particles.inverse_mass(i) * push;
        a.x()[i] = sum.x, a.y()[i] = sum.y, a.z()[i] = sum.z;
    };
    for (const std::size_t i : pairs.first) {
        Vector<T> sum{T(0), T(0), T(0)};
        for (std::size_t j = pairs.second.empty() ? i + 1 : pairs.first.size(); j < u.count(); ++j) {
            const Vector<T> d = vector(u, j) - vector(u, i);
            const T distance2 = d.x * d.x + d.y * d.y + d.z * d.z;
            const T factor = distance2 > T(0) ? potential.factor(distance2, particles.properties(i, j)) : T(0);
            sum = sum + factor * d;
            add(j, factor * d);
        }
        add(i, Vector<T>{-sum.x, -sum.y, -sum.z});
    }
}

TYPED_TEST(ComposedSums, few_pairs_are_those_added_row_by_row) {
    const Field<TypeParam> all = near_a_lattice<TypeParam>(3, 1, 0.2);
    for (const std::string potential : {"gravity", "m1 * m2 * exp(-r) / r"}) {
        for (std::size_t count = 2; count <= 16; ++count) {
            for (const std::size_t second : {std::size_t(0), count - count / 2}) {
                Composition terms;
                terms.count = count;
                give_masses_and_fix_some(terms);
                terms.pairs = {pairs_without_cutoff(potential, count - second, second)};
                const ComposedParticles<TypeParam> particles(std::make_shared<const Composition>(terms));
                Field<TypeParam> u(count), a(count);
                copy(all, 0, count, u, 0);
                if (count > 4) u.set(4, u.at(3));
                for (std::size_t i = 0; i < count; ++i) a.set(i, terms.accelerations[i]);
                add_row_by_row(terms.pairs[0], particles, u, a);
                for (std::size_t i = 0; i < count; ++i) a.set(i, terms.fixed[i] != 0 ? Vec3{} : a.at(i));
                Composed<TypeParam> force(forces_of(terms));
                expect_same(sums(force, u), a, potential + ", " + std::to_string(count));
            }
        }
    }
}

ComposedPairs pairs_between_all(const std::string& potential, std::size_t count) {
    ComposedPairs pairs;
    pairs.cutoff = 1.7;
    if (potential == "morse") pairs.values = {1, 50, 1};
    if (potential == "lennard-jones") pairs.values = {1, 0.9};
    if (pairs.values.empty()) {
        PairTerm term{.potential = potential};
        term.cutoff = pairs.cutoff;
        pairs.expression = expression_of(term, 2);
    } else {
        pairs.potential = potential;
    }
    pairs.first.resize(count);
    std::iota(pairs.first.begin(), pairs.first.end(), 0U);
    return pairs;
}

constexpr std::size_t side = 8;
const std::vector<std::string> potentials{"morse", "lennard-jones", "exp(-r)/r + 0.1*r^3"};

/// Two kinds of particles, some of them fixed; `terms` of pairs between all.
Composition liquid(const std::vector<std::string>& terms, double period) {
    Composition composition;
    composition.count = side * side * side;
    give_masses_and_fix_some(composition);
    composition.box = {period, period, period};
    for (const std::string& potential : terms)
        composition.pairs.push_back(pairs_between_all(potential, side * side * side));
    return composition;
}

/// The same forces, written as between two sets that are both all particles: these go neighbour by neighbour.
Composition without_clusters(Composition composition) {
    for (ComposedPairs& pairs : composition.pairs) pairs.second = pairs.first;
    return composition;
}

/// Rounding of the largest of some fifty terms: of the order of ten units in the last place of a force of 100.
template <class T>
T rounding() {
    return 4000 * std::numeric_limits<T>::epsilon();
}

TYPED_TEST(ComposedSums, clusters_find_the_pairs_that_neighbours_are) {
    const Field<TypeParam> u = near_a_lattice<TypeParam>(side, 1, 0.15);
    for (const double period : {0.0, 8.0}) {
        for (const std::string& potential : potentials) {
            const Composition terms = liquid({potential}, period);
            Composed<TypeParam> force(forces_of(terms)), other(forces_of(without_clusters(terms)));
            const Field<TypeParam> a = sums(force, u), b = sums(other, u);
            EXPECT_EQ(force.history().count(), u.count()) << "by clusters";
            EXPECT_EQ(other.history().count(), 0u);
            for (std::size_t i = 0; i < u.count(); ++i)
                EXPECT_LT(length(a.at(i) - b.at(i)), rounding<TypeParam>() * (1 + length(b.at(i)))) << potential << i;
            const PotentialEnergy energy = force.potential(u), same = other.potential(u);
            EXPECT_NEAR(energy.value, same.value, rounding<TypeParam>() * same.magnitude);
            EXPECT_NEAR(energy.magnitude, same.magnitude, rounding<TypeParam>() * same.magnitude);
        }
    }
}

TYPED_TEST(ComposedSums, energies_of_clusters_count_every_pair_once) {
    const Field<TypeParam> u = near_a_lattice<TypeParam>(side, 1, 0.15);
    for (const std::string& potential : potentials) {
        Composition terms = liquid({potential}, 8);
        terms.fixed.clear();
        const PotentialEnergy energy = Composed<TypeParam>(forces_of(terms)).potential(u);
        const PotentialEnergy same = Composed<TypeParam>(forces_of(without_clusters(terms))).potential(u);
        EXPECT_NEAR(energy.value, same.value, rounding<TypeParam>() * same.magnitude) << potential;
    }
}

// What is handed out is what accelerations() writes; neither depends on the number of threads, nor observers change
// what comes after.
TYPED_TEST(ComposedSums, clusters_give_the_same_bits_to_all) {
    const Field<TypeParam> u = near_a_lattice<TypeParam>(side, 1, 0.1),
                           moved = near_a_lattice<TypeParam>(side, 1, 0.25);
    for (const std::vector<std::string>& terms : {std::vector<std::string>{potentials[1]}, potentials}) {
        Composed<TypeParam> one(forces_of(liquid(terms, 8))), three(forces_of(liquid(terms, 8), 3));
        const Field<TypeParam> expected = sums(one, u);
        expect_same(sums(three, u), expected, "three threads");
        expect_same(handed_out(three, u), expected, "handed out");
        const Field<TypeParam> made_at = one.history();
        Field<TypeParam> seen(u.count());
        one.uncounted_accelerations(moved, seen);
        expect_same(one.history(), made_at, "history");
        expect_same(sums(one, u), expected, "after an observer");
        three.history(moved);
        three.history(made_at);
        expect_same(sums(three, u), expected, "from a history");
    }
}

// The partner: lists made elsewhere give other last bits, which is why history is part of a run.
TYPED_TEST(ComposedSums, clusters_made_elsewhere_change_the_last_bits) {
    const Field<TypeParam> u = near_a_lattice<TypeParam>(side, 1, 0.05);
    Field<TypeParam> nearby = u;
    for (std::size_t i = 0; i < u.count(); ++i) nearby.set(i, u.at(i) + Vec3{0.03 * static_cast<double>(i % 3), 0, 0});
    Composed<TypeParam> force(forces_of(liquid({potentials[1]}, 8)));
    const Field<TypeParam> at_u = sums(force, u);
    force.history(nearby);
    const Field<TypeParam> at_nearby = sums(force, u);
    EXPECT_EQ(force.history().at(1), nearby.at(1)) << "still holds";
    std::size_t other = 0;
    for (std::size_t i = 0; i < u.count(); ++i) other += at_u.at(i) == at_nearby.at(i) ? 0 : 1;
    EXPECT_GT(other, 0u);
}

}  // namespace
}  // namespace steplab::test
