#include "sim/steppers/reordered.hpp"

#include "models/scene/potential_expression.hpp"
#include "sim/steppers/bands.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <any>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

namespace steplab::test {
namespace {

/// A cube of particles on springs to their next ones along each axis, numbered in any order, a third of them heavy and
/// a few of them fixed, each in its own field; with some dashpots and drag.
Plan jelly(std::size_t side, bool damped = true) {
    const std::size_t count = side * side * side;
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0U);
    std::mt19937 random(7);
    for (std::size_t i = count - 1; i > 0; --i) std::swap(numbers[i], numbers[random() % (i + 1)]);
    Composition terms;
    terms.count = count;
    terms.reference.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        terms.reference[numbers[i]] = {double(i % side), double(i / side % side), double(i / side / side)};
    for (std::size_t i = 0; i < count; ++i) {
        terms.masses.push_back(i % 3 == 0 ? 2 : 1);
        terms.fixed.push_back(i % 500 == 0 ? 1 : 0);
        if (damped) terms.drag.push_back(i % 500 == 0 ? 0 : 0.01 * double(i % 2));
        terms.accelerations.push_back({0, -0.01 * double(i % 4), 0});
        for (const auto& [step, inside] :
             {std::pair{std::size_t{1}, i % side + 1 < side}, std::pair{side, i / side % side + 1 < side},
              std::pair{side * side, i / side / side + 1 < side}}) {
            if (!inside) continue;
            const std::uint32_t first = numbers[i], second = numbers[i + step];
            terms.springs.push_back({.first = first,
                                     .second = second,
                                     .rest = terms.reference[second] - terms.reference[first],
                                     .length = 1,
                                     .k = 4,
                                     .damping = damped && i % 7 == 0 ? 0.1 : 0});
        }
    }
    ComposedField field = expression_of(FieldTerm{.potential = "0.3*m*x*y + 0.1*z^2"}, 1);
    for (std::uint32_t i = 0; i < count; i += 3) {
        if (terms.fixed[i] == 0) field.particles.push_back(i);
    }
    terms.fields = {field};
    Plan plan;
    plan.masses = terms.masses;
    plan.reference.count = plan.reference.columns = count;
    plan.reference.points = std::make_shared<const std::vector<Vec3>>(terms.reference);
    plan.start = {count, [fixed = terms.fixed](std::size_t i) {
                      const Vec3 velocity{std::sin(double(i)), std::cos(double(i)), 0.1};
                      return Start::Particle{{}, fixed[i] != 0 ? Vec3{} : velocity};
                  }};
    plan.forces = ComposedForces{count, 1, std::make_shared<const Composition>(std::move(terms))};
    return plan;
}

State<double> state_of(const Stepper& stepper) {
    State<double> state;
    stepper.synchronised(state);
    return state;
}

double farthest(const State<double>& a, const State<double>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.displacement.count(); ++i) {
        most = std::max(most, length(a.displacement.at(i) - b.displacement.at(i)));
        most = std::max(most, length(a.velocity.at(i) - b.velocity.at(i)));
    }
    return most;
}

TEST(OrderByPlace, brings_together_what_springs_join) {
    const Plan scene = jelly(16);
    const Composition& terms = *std::get<ComposedForces>(scene.forces).terms;
    const std::vector<std::uint32_t> order = order_by_place(scene);
    ASSERT_EQ(order.size(), 4096u);
    std::vector<std::uint32_t> places(order.size(), 5000);
    for (std::uint32_t place = 0; place < order.size(); ++place) places[order[place]] = place;
    EXPECT_EQ(std::ranges::count(places, 5000U), 0) << "every particle has a place";
    Vec3 before, after;  // sums over the springs along each axis, of which there are as many
    for (const ComposedSpring& spring : terms.springs) {
        before = before + std::abs(double(spring.first) - double(spring.second)) * spring.rest;
        after = after + std::abs(double(places[spring.first]) - double(places[spring.second])) * spring.rest;
    }
    EXPECT_LT(after.x, before.x / 4);
    EXPECT_LT(after.y, before.y / 4);
    EXPECT_LT(after.z, before.z / 4);
}

TEST(OrderByPlace, leaves_few_particles_and_those_of_pair_forces_alone) {
    EXPECT_TRUE(order_by_place(jelly(6)).empty());
    Plan scene = jelly(16);
    Composition terms = *std::get<ComposedForces>(scene.forces).terms;
    ComposedPairs pairs;
    pairs.potential = "morse";
    pairs.values = {1, 1, 1};
    pairs.first = {0, 1};
    terms.pairs = {pairs};
    scene.forces = ComposedForces{terms.count, 1, std::make_shared<const Composition>(terms)};
    EXPECT_TRUE(order_by_place(scene).empty());
    EXPECT_TRUE(order_by_place(model("mesh").plan(describe("mesh").scene)).empty());
}

class Reordered : public testing::TestWithParam<MethodCase> {};

// Each particle's sums have the same terms in the same order: the same bits. Methods that sum over particles, in norms
// of errors and solves, differ within their tolerances: these are 1e-6 and finer.
TEST_P(Reordered, particles_move_as_in_the_order_of_the_scene) {
    const auto& [info, precision] = GetParam();
    const Method& entry = method(info->id);
    const bool sums_over_particles = !entry.runs_in_lanes(fastest_instructions());
    // damping is of order 2 in methods of own steps: they would be small ones
    const Plan scene = jelly(13, !sums_over_particles);
    ASSERT_FALSE(order_by_place(scene).empty());
    const ParameterValues parameters(info->parameters);
    const StepperSetup setup{scene, scene.start, parameters, precision, 0.05};
    const auto plain = entry.make(setup);
    plain->advance(3);
    const State<double> expected = state_of(*plain);
    for (const std::size_t threads :
         sums_over_particles ? std::vector<std::size_t>{3} : std::vector<std::size_t>{1, 3}) {
        const auto reordered = make_stepper(entry, setup, {.threads = threads, .particles_a_thread = 1});
        reordered->advance(2);
        std::any moment;
        reordered->save(moment);
        reordered->advance(1);
        reordered->restore(moment);
        reordered->advance(1);
        const double apart = farthest(state_of(*reordered), expected);
        if (sums_over_particles)
            EXPECT_LT(apart, precision == Precision::float_ ? 1e-3 : 1e-5);
        else
            EXPECT_EQ(apart, 0);
    }
}

std::vector<MethodCase> methods_of_any_forces() {
    std::vector<MethodCase> cases;
    for (const MethodCase& c : all_methods()) {
        if (c.info->id != "verlet-2008" && c.info->id != "velocity-verlet-2008" && c.info->id != "taylor")
            cases.push_back(c);
    }
    return cases;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Reordered, testing::ValuesIn(methods_of_any_forces()), case_name);

TEST(CollisionRecord, calls_particles_by_their_names) {
    CollisionRecord record;
    record.add({.time = 1, .first = 0, .second = 2});
    const std::vector<std::uint32_t> names{7, 8, 9};
    const CollisionRecord named = record.with_particles(names);
    ASSERT_EQ(named.count(), 1u);
    EXPECT_EQ(named.kept()[0], (Collision{1, 7, 9}));
}

}  // namespace
}  // namespace steplab::test
