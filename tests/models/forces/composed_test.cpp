#include "core/dual.hpp"
#include "models/forces/layouts.hpp"
#include "models/scene/potential_expression.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

ComposedForces composed(Composition terms) {
    const std::size_t count = terms.count;
    const double mass = terms.mass;
    return {count, mass, std::make_shared<const Composition>(std::move(terms))};
}

Field<double> random_positions(std::size_t count, double size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, size);
    Field<double> field(count);
    for (std::size_t i = 0; i < count; ++i) field.set(i, {uniform(random), uniform(random), uniform(random)});
    return field;
}

std::vector<std::uint32_t> numbers(std::uint32_t from, std::uint32_t to) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = from; i < to; ++i) all.push_back(i);
    return all;
}

/// Every kind of term between particles of different masses and charges; the last particle is fixed.
Composition everything(Vec3 box, double cutoff) {
    Composition terms;
    terms.count = 9;
    terms.mass = 2;
    for (std::size_t i = 0; i < 9; ++i) {
        terms.masses.push_back(1 + 0.25 * static_cast<double>(i));
        terms.charges.push_back(i % 2 == 0 ? 1 : -0.5);
        terms.fixed.push_back(i == 8 ? 1 : 0);
    }
    terms.box = box;
    terms.springs = {{.first = 0, .second = 1, .length = 1, .stretch = -1, .k = 3, .quadratic = 0.5, .cubic = 2},
                     {.first = 2, .second = 8, .length = 0, .k = 2}};
    const std::vector<std::pair<std::string, std::vector<double>>> potentials{
        {"morse", {1, 5, 1}}, {"lennard-jones", {1, 0.6}}, {"gravity", {0.8, 0.3}}, {"coulomb", {0.8, 0}}};
    for (const auto& [potential, values] : potentials) {
        ComposedPairs pairs;
        pairs.potential = potential;
        pairs.values = values;
        pairs.cutoff = cutoff;
        pairs.first = potential == "coulomb" ? numbers(0, 4) : numbers(0, 9);
        if (potential == "coulomb") pairs.second = numbers(3, 9);
        terms.pairs.push_back(pairs);
    }
    PairTerm expression{.potential = "0.3*m1*m2*exp(-r) - q1*q2*tanh(r)/(1 + r)"};
    if (cutoff > 0) expression.cutoff = cutoff;
    ComposedPairs written;
    written.cutoff = cutoff;
    written.expression = expression_of(expression, terms.mass);
    written.first = numbers(0, 9);
    terms.pairs.push_back(written);
    ComposedField field = expression_of(FieldTerm{.potential = "m*sin(x)*y^2 + q*z^3/(1 + x^2)"}, terms.mass);
    field.particles = numbers(1, 8);
    terms.fields = {field};
    terms.accelerations = {{0.1, -9.81, 0.3}};
    return terms;
}

double total(const ComposedForces& forces, const Field<double>& x) { return engine<double>(forces).potential(x).value; }

// Central differences of step h: their error is h^2 times third derivatives, some 1e4 here, and rounding 1e-16 / h.
TEST(Composed, forces_are_the_slopes_of_the_energy) {
    for (const auto& [box, cutoff] : {std::pair{Vec3{}, 0.0}, std::pair{Vec3{}, 1.4}, std::pair{Vec3{4, 5, 0}, 1.4}}) {
        const Composition terms = everything(box, cutoff);
        const ComposedForces forces = composed(terms);
        const Field<double> x = random_positions(9, 2.5, 7);
        Field<double> a(9);
        engine<double>(forces).accelerations(x, a);
        const double h = 1e-6;
        for (std::size_t k = 0; k < x.flat().size(); ++k) {
            Field<double> up = x, down = x;
            up.flat()[k] += h;
            down.flat()[k] -= h;
            const std::size_t stride = x.flat().size() / 3, i = k % stride;
            if (i >= 9) continue;  // of the register's rest
            const double slope = (total(forces, up) - total(forces, down)) / (2 * h);
            const double force = i == 8 ? 0 : a.flat()[k] * terms.mass * terms.masses[i];
            EXPECT_NEAR(force, i == 8 ? 0 : -slope, 1e-6 * (1 + std::abs(slope))) << k << " cutoff " << cutoff;
        }
    }
}

TEST(Composed, forces_within_a_scene_cancel_and_do_not_turn_it) {
    Composition terms = everything({}, 0);
    terms.fixed.clear();
    terms.accelerations.clear();
    terms.fields.clear();
    const Field<double> x = random_positions(9, 2.5, 3);
    Field<double> a(9);
    engine<double>(composed(terms)).accelerations(x, a);
    Vec3 sum, turning;
    double size = 0;
    for (std::size_t i = 0; i < 9; ++i) {
        const Vec3 force = terms.masses[i] * a.at(i);
        sum = sum + force;
        turning = turning + cross(x.at(i), force);
        size += length(force);
    }
    EXPECT_LT(length(sum), 1e-15 * 9 * size);
    EXPECT_LT(length(turning), 1e-15 * 9 * 2.5 * size);
}

TEST(Composed, agrees_with_the_layouts_of_models) {
    for (const char* const id : {"chain", "mesh", "morse"}) {
        const RunDescription run = describe(id);
        const Plan plan = model_of(run).plan(run.scene);
        Composition terms;
        const State<double> start = plan.start.state();
        terms.count = start.displacement.count();
        if (id == std::string("morse")) {
            ComposedPairs pairs;
            pairs.potential = "morse";
            pairs.values = {run.scene["D"], run.scene["k"], run.scene["r0"]};
            pairs.first = numbers(0, static_cast<std::uint32_t>(terms.count));
            terms.pairs = {pairs};
        } else {
            const Shape shape = model_of(run).shape(run.scene);
            for (const Role role : shape.roles) terms.fixed.push_back(role == Role::fixed ? 1 : 0);
            for (const Spring& spring : shape.springs) {
                terms.springs.push_back({.first = spring.first,
                                         .second = spring.second,
                                         .rest = shape.rest[spring.second] - shape.rest[spring.first],
                                         .length = spring.rest_length,
                                         .k = run.scene["k"]});
            }
            terms.reference = shape.rest;
        }
        Field<double> u = random_positions(terms.count, 0.05, 1), a(terms.count), b(terms.count);
        for (std::size_t i = 0; i < terms.count; ++i)
            u.set(i, !terms.fixed.empty() && terms.fixed[i] != 0 ? Vec3{} : u.at(i) + start.displacement.at(i));
        engine<double>(composed(terms)).accelerations(u, a);
        std::visit([&](const auto& layout) { engine<double>(layout).accelerations(u, b); }, plan.forces);
        for (std::size_t i = 0; i < terms.count; ++i)
            EXPECT_LT(length(a.at(i) - b.at(i)), 1e-13 * (1 + length(b.at(i)))) << id << ' ' << i;
    }
}

TEST(Composed, coincident_particles_feel_nothing) {
    Composition terms = everything({}, 0);
    terms.accelerations.clear();
    terms.fields.clear();
    Field<double> x(9), a(9);
    engine<double>(composed(terms)).accelerations(x, a);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(a.at(i), Vec3{}) << i;
    EXPECT_TRUE(std::isfinite(total(composed(terms), x)));
}

TEST(Composed, images_across_a_box_are_as_near_as_neighbours) {
    Composition terms;
    terms.count = 2;
    terms.box = {10, 0, 6};
    ComposedPairs pairs;
    pairs.potential = "morse";
    pairs.values = {1, 1, 1};
    pairs.cutoff = 2;
    pairs.first = {0, 1};
    terms.pairs = {pairs};
    const auto acceleration = [&](Vec3 second) {
        Field<double> x(2), a(2);
        x.set(1, second);
        engine<double>(composed(terms)).accelerations(x, a);
        return a.at(0);
    };
    const Vec3 beside = acceleration({0.75, 0, 0.5});
    EXPECT_NE(beside, Vec3{});
    EXPECT_LT(length(acceleration({10.75, 0, -5.5}) - beside), 1e-13);
    EXPECT_EQ(acceleration({0.75, 10, 0.5}), Vec3{}) << "not periodic along y";
}

// In a box of unequal sides, wherever particles are: the lists of neighbours find every pair that a search over all
// finds. Sums of a hundred terms in another order: 1e-13.
TEST(Composed, lists_of_neighbours_in_any_box_miss_no_pair) {
    for (const Vec3 box : {Vec3{5, 7, 0}, Vec3{0, 4, 9}, Vec3{4, 4, 4}, Vec3{}}) {
        Composition terms;
        terms.count = 60;
        terms.box = box;
        ComposedPairs pairs;
        pairs.potential = "morse";
        pairs.values = {1, 5, 1};
        pairs.cutoff = 1.5;
        pairs.first = numbers(0, 60);
        terms.pairs = {pairs};
        const Field<double> x = random_positions(60, 12, 11);
        Field<double> a(60);
        engine<double>(composed(terms)).accelerations(x, a);
        const ShiftedPotential<double, MorsePotential<double>> potential(pairs.values, 1.5, 1);
        const auto nearest = [](double d, double side) { return side > 0 ? d - side * std::nearbyint(d / side) : d; };
        for (std::size_t i = 0; i < 60; ++i) {
            Vec3 sum;
            for (std::size_t j = 0; j < 60; ++j) {
                const Vec3 d = x.at(j) - x.at(i);
                const Vec3 near{nearest(d.x, box.x), nearest(d.y, box.y), nearest(d.z, box.z)};
                if (i == j || !(dot(near, near) < 1.5 * 1.5)) continue;
                sum = sum - potential.factor(dot(near, near), PairProperties<double>{}) * near;
            }
            EXPECT_LT(length(a.at(i) - sum), 1e-13 * (1 + length(sum))) << i << " box " << box.x;
        }
    }
}

Composition damped() {
    Composition terms = everything({}, 0);
    terms.springs[0].damping = 0.7;
    terms.springs[1].damping = 1.3;
    terms.springs.push_back({.first = 3, .second = 1, .length = 1, .k = 1, .damping = 0.4});
    for (std::size_t i = 0; i < 9; ++i) terms.drag.push_back(0.1 * static_cast<double>(i));
    return terms;
}

// D v by its blocks is what accelerations lose, and never drives: v.M D v >= 0. Rounding of sums of a few terms: 1e-14.
TEST(Composed, damping_is_symmetric_and_takes_energy) {
    const Composition terms = damped();
    auto force = engine<double>(composed(terms));
    const Field<double> x = random_positions(9, 2.5, 5);
    Field<double> v = random_positions(9, 1, 6), lost(9), summed(9);
    v.set(8, {});
    force.add_damping(x, v, lost);
    force.each_damping(x, [&](std::size_t i, std::size_t j, const Block<double>& block) {
        EXPECT_LE(i, j);
        const auto times = [&](Vec3 a) {
            const auto& b = block.at;
            return Vec3{b[0][0] * a.x + b[0][1] * a.y + b[0][2] * a.z, b[1][0] * a.x + b[1][1] * a.y + b[1][2] * a.z,
                        b[2][0] * a.x + b[2][1] * a.y + b[2][2] * a.z};
        };
        const Vec3 pull = times(i == j ? v.at(i) : v.at(i) - v.at(j));
        summed.set(i, summed.at(i) - (1 / terms.masses[i]) * pull);
        if (i != j) summed.set(j, summed.at(j) + (1 / terms.masses[j]) * pull);
    });
    double power = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_LT(length(lost.at(i) - summed.at(i)), 1e-14) << i;
        power += terms.masses[i] * dot(v.at(i), lost.at(i));
    }
    EXPECT_LT(power, -0.1);
    EXPECT_EQ(lost.at(8), Vec3{}) << "held";
}

// The flow against its rate: symmetric, so two flows of opposite times cancel to rounding, and over a small time the
// change is that of the rate with an error of the square of the time.
TEST(Composed, flow_of_damping_follows_its_rate_and_runs_back) {
    auto force = engine<double>(composed(damped()));
    const Field<double> x = random_positions(9, 2.5, 5);
    Field<double> start = random_positions(9, 1, 6);
    start.set(8, {});
    Field<double> rate(9), v = start;
    force.add_damping(x, start, rate);
    force.damp(x, v, 1e-4);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_LT(length(v.at(i) - start.at(i) - 1e-4 * rate.at(i)), 1e-7) << i;
    force.damp(x, v, -1e-4);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_LT(length(v.at(i) - start.at(i)), 1e-15) << i;
}

}  // namespace
}  // namespace steplab::test
