#include "sim/run/observables.hpp"

#include "core/error.hpp"
#include "models/forces/layouts.hpp"
#include "models/scene/planner.hpp"
#include "sim/run/radial_distribution.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::test {
namespace {

double potential(const Forces& forces, const Field<double>& u) {
    return std::visit([&](const auto& layout) { return engine<double>(layout).potential(u).value; }, forces);
}

/// W = -dU / d(lambda) where space is stretched by lambda, the box too; by a central difference of fourth order.
template <class Stretched>
double virial_by_stretching(const Stretched& energy) {
    constexpr double h = 1e-3;
    return -(8 * (energy(1 + h) - energy(1 - h)) - (energy(1 + 2 * h) - energy(1 - 2 * h))) / (12 * h);
}

Field<double> scaled(const Field<double>& u, double factor) {
    Field<double> result = u;
    for (double& number : result.flat()) number *= factor;
    return result;
}

TEST(Observables, virial_is_the_change_of_energy_where_space_is_stretched) {
    const RunDescription run = run_of("crystal", "rk4", Precision::double_, 0.01, {{"edge", 6}});
    const Plan plan = model_of(run).plan(run.scene);
    const State<double> start = plan.start.state();
    const auto energy = [&](double factor) {
        NearPairForces forces = std::get<NearPairForces>(plan.forces);
        forces.period *= factor;
        return potential(forces, scaled(start.displacement, factor));
    };
    const double expected = virial_by_stretching(energy);
    // h^4 of the difference, and pairs that cross the cut-off, where the second derivative jumps
    EXPECT_NEAR(virial(plan.forces, start.displacement), expected, 1e-3 * std::abs(expected));
}

/// Two kinds of particles in a box: masses, charges, springs.
Scene mixture() {
    Scene scene;
    scene.particles = {
        {.group = "a", .mass = 2, .charge = 1, .arrangement = LineArrangement{5, {1.1, 0.3, 0}}},
        {.group = "b", .position = {0, 2, 0.5}, .charge = -1, .arrangement = LineArrangement{4, {1.2, 0, 0.4}}}};
    scene.springs = {{.between = "b", .k = 3, .length = WrittenNumber(1)}};
    scene.pairs = {
        {.between = {"a", "b"}, .potential = "coulomb", .values = {{"K", 0.7}}, .cutoff = WrittenNumber(4)},
        {.potential = "lennard-jones", .values = {{"epsilon", 0.3}, {"sigma", 1}}, .cutoff = WrittenNumber(3)}};
    scene.box = {12, 12, 12};
    return scene;
}

TEST(Observables, virial_of_a_mixture_too) {
    const Plan plan = planned(mixture());
    const auto& composed = std::get<ComposedForces>(plan.forces);
    const State<double> start = plan.start.state();
    const auto energy = [&](double factor) {
        auto terms = std::make_shared<Composition>(*composed.terms);
        terms->box = factor * terms->box;
        return potential(ComposedForces{composed.count, composed.mass, terms}, scaled(start.displacement, factor));
    };
    const double expected = virial_by_stretching(energy);
    EXPECT_NEAR(virial(plan.forces, start.displacement), expected, 1e-7 * std::abs(expected));  // h^4 of the difference
    Observables observables(plan, {Observable::pressure});
    EXPECT_NEAR(*observables.of(start)[0], expected / 3 / (12. * 12 * 12), 1e-9) << "cold";
}

TEST(Observables, temperature_is_what_the_scene_was_made_with) {
    Scene scene = mixture();
    scene.particles[0].temperature = Temperature{.kT = 0.7, .seed = 3, .exact = true};
    scene.particles.pop_back();
    scene.springs.clear();
    scene.pairs.erase(scene.pairs.begin());
    const Plan plan = planned(scene);
    Observables observables(plan, parse_observables("kT,pressure"));
    State<double> state = plan.start.state();
    const auto values = observables.of(state);
    EXPECT_NEAR(*values[0], 0.7, 1e-14);  // rounding of sums over 5 particles
    for (std::size_t i = 0; i < 5; ++i) state.velocity.set(i, state.velocity.at(i) + Vec3{3, 0, 0});
    EXPECT_NEAR(*observables.of(state)[0], 0.7, 1e-13) << "a drift is no heat";
    const double volume = 12. * 12 * 12;
    EXPECT_NEAR(*values[1], (5 * 0.7 + virial(plan.forces, state.displacement) / 3) / volume, 1e-15);
}

TEST(Observables, are_none_where_they_are_not_defined) {
    const RunDescription run = describe("morse");
    const Plan plan = model_of(run).plan(run.scene);
    Observables observables(plan, parse_observables("pressure,kT"));
    EXPECT_FALSE(observables.of(plan.start.state())[0]) << "without a box";
    EXPECT_TRUE(observables.of(plan.start.state())[1]);
    Scene single;
    single.particles.emplace_back();
    const Plan alone = planned(single);
    EXPECT_FALSE(Observables(alone, {Observable::kT}).of(alone.start.state())[0]);
    EXPECT_THROW(parse_observables("kT,heat"), UsageError);
}

TEST(Observables, displacement_is_that_of_moving_particles_since_the_first_state) {
    const RunDescription run = run_of("chain", "rk4", Precision::double_, 0.01, {{"n", 3}});
    const Plan plan = model_of(run).plan(run.scene);
    Observables observables(plan, {Observable::msd});
    State<double> state = plan.start.state();
    EXPECT_EQ(*observables.of(state)[0], 0);
    state.displacement.set(1, {3, 0, 0});
    state.displacement.set(2, {0, 4, 0});
    EXPECT_EQ(*observables.of(state)[0], 12.5) << "(9 + 16) / 2: particle 0 is fixed";
}

TEST(RadialDistribution, has_the_shells_of_a_cubic_lattice) {
    std::vector<Vec3> lattice;
    for (int i = 0; i < 216; ++i) lattice.push_back({1.0 * (i % 6), 1.0 * (i / 6 % 6), 1.0 * (i / 36)});
    RadialDistribution rdf({6, 6, 6}, 30);  // bins of 0.1
    rdf.add(lattice);
    rdf.add(lattice);
    const auto neighbours = [&](std::size_t bin) {  // of a particle: g times those of an ideal gas
        const double inner = 0.1 * static_cast<double>(bin), outer = inner + 0.1;
        return rdf[bin] * 215 / 216.0 * 4 * 3.14159265358979 / 3 * (std::pow(outer, 3) - std::pow(inner, 3));
    };
    EXPECT_EQ(rdf[5], 0);
    EXPECT_NEAR(neighbours(14), 12, 1e-9) << "at sqrt(2)";
    EXPECT_NEAR(neighbours(17), 8, 1e-9) << "at sqrt(3)";
    EXPECT_NEAR(neighbours(9) + neighbours(10), 6, 1e-9) << "at 1, on the border of two bins";
}

// A lattice of cells 1 x 1 x 1.5 in a box of 4 x 5 x 9: two neighbours at 1 along each of two axes, two at 1.5, and
// four pairs of diagonals.
TEST(RadialDistribution, knows_boxes_of_unequal_sides) {
    std::vector<Vec3> lattice;
    for (int i = 0; i < 120; ++i) lattice.push_back({1.0 * (i % 4), 1.0 * (i / 4 % 5), 1.5 * (i / 20)});
    RadialDistribution rdf({4, 5, 9}, 19);
    rdf.add(lattice);
    const auto neighbours = [&](double r) {
        const double width = 2.0 / 19, inner = width * std::floor(r / width), outer = inner + width;
        return rdf[static_cast<std::size_t>(r / width)] * 119 / 180.0 * 4 * 3.14159265358979 / 3 *
               (std::pow(outer, 3) - std::pow(inner, 3));
    };
    EXPECT_DOUBLE_EQ(rdf.distance(18), 2 - 1.0 / 19) << "half the shortest side";
    EXPECT_NEAR(neighbours(1), 4, 1e-9);
    EXPECT_NEAR(neighbours(std::sqrt(2.0)), 4, 1e-9);
    EXPECT_NEAR(neighbours(1.5), 2, 1e-9);
    EXPECT_NEAR(neighbours(std::sqrt(3.25)), 8, 1e-9);
}

}  // namespace
}  // namespace steplab::test
