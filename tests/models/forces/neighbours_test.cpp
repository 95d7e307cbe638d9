#include "models/forces/neighbours.hpp"

#include "models/forces/layouts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace steplab {
namespace {

Field<double> ensemble(std::size_t count, double size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-size, size);
    Field<double> field(count);
    for (std::size_t i = 0; i < count; ++i) field.set(i, {place(random), place(random), place(random)});
    return field;
}

TEST(Neighbours, are_all_within_reach_in_order) {
    const Field<double> field = ensemble(300, 3, 5);
    Neighbours neighbours(1);
    neighbours.follow(field);
    for (std::size_t i = 0; i < 300; ++i) {
        std::vector<std::uint32_t> expected;
        for (std::uint32_t j = 0; j < 300; ++j) {
            if (j != i && length(field.at(i) - field.at(j)) <= 1.15) expected.push_back(j);
        }
        const auto found = neighbours.of(i);
        EXPECT_THAT(std::vector<std::uint32_t>(found.begin(), found.end()), testing::ElementsAreArray(expected)) << i;
    }
}

TEST(Neighbours, are_nearest_images_with_periodic_boundary_conditions) {
    for (const double period : {2.5, 3.7, 6.0}) {
        const Field<double> field = ensemble(200, 5, 6);
        Neighbours neighbours(1, period);
        neighbours.follow(field);
        const auto nearest = [=](double d) { return d - period * std::round(d / period); };
        for (std::size_t i = 0; i < 200; ++i) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t j = 0; j < 200; ++j) {
                const Vec3 d = field.at(j) - field.at(i);
                if (j != i && length({nearest(d.x), nearest(d.y), nearest(d.z)}) <= 1.15) expected.push_back(j);
            }
            const auto found = neighbours.of(i);
            EXPECT_THAT(std::vector<std::uint32_t>(found.begin(), found.end()), testing::ElementsAreArray(expected));
        }
    }
}

TEST(Neighbours, accept_particles_without_a_valid_position) {
    Field<double> field = ensemble(10, 1, 1);
    field.set(3, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
    field.set(4, {1e300, -1e300, 0});
    Neighbours neighbours(1);
    neighbours.follow(field);
    EXPECT_TRUE(neighbours.of(3).empty());
    EXPECT_TRUE(neighbours.of(4).empty());
}

TEST(NearPairs, with_a_cut_off_beyond_everything_are_all_pairs) {
    const PairForces pairs{.count = 40, .mass = 2, .depth = 1, .k = 0.5, .r0 = 0.5};
    const Field<double> field = ensemble(40, 1, 4);
    Field<double> near(40), all(40);
    NearPairs<double>(NearPairForces{pairs, 100}).accelerations(field, near);
    Pairs<double>(pairs).accelerations(field, all);
    // the same pairs in another order: sums of 39 numbers below 1
    for (std::size_t k = 0; k < near.flat().size(); ++k) EXPECT_NEAR(near.flat()[k], all.flat()[k], 1e-14);
}

TEST(NearPairs, have_a_continuous_energy_at_the_cut_off) {
    const NearPairForces forces{{.count = 2, .mass = 1, .depth = 1, .k = 0.5, .r0 = 0.5}, 1};
    const auto energy = [&](double distance) {
        Field<double> field(2);
        field.set(1, {distance, 0, 0});
        return NearPairs<double>(forces).potential(field).value;
    };
    EXPECT_NEAR(energy(1 - 1e-9), 0,
                2e-16);  // quadratic in the distance to the cut-off: only roundings of numbers below 1 remain
    EXPECT_EQ(energy(1 + 1e-9), 0);
    EXPECT_GT(energy(0.5), 0.01);
}

/// The acceleration of the second of two particles at this distance, along the line between them.
template <class T>
double pull(const NearPairForces& forces, double distance) {
    Field<T> u(2), a(2);
    u.set(1, {distance, 0, 0});
    NearPairs<T>(forces).accelerations(u, a);
    return static_cast<double>(a.x()[1]);
}

TEST(NearPairs, have_a_continuous_force_at_the_cut_off) {
    const NearPairForces forces{{.count = 2, .mass = 2, .depth = 1, .k = 0.5, .r0 = 0.5}, 1};
    const Vector<double> uncut = morse_pull(morse_constants<double>(PairForces(forces)), Vector<double>{1, 0, 0});
    EXPECT_LT(uncut.x, -0.05);  // the shift
    for (const auto& just_within :
         {pull<float>(forces, 1 - 1e-6), pull<double>(forces, 1 - 1e-6), pull<long double>(forces, 1 - 1e-6)})
        EXPECT_NEAR(just_within, 0, 1e-6);  // the slope is below 1
    EXPECT_EQ(pull<double>(forces, 1), 0);
}

TEST(NearPairs, have_the_force_that_is_the_slope_of_their_energy) {
    const NearPairForces forces{{.count = 2, .mass = 2, .depth = 1, .k = 0.5, .r0 = 0.5}, 1};
    const auto energy = [&](double distance) {
        Field<double> u(2);
        u.set(1, {distance, 0, 0});
        return NearPairs<double>(forces).potential(u).value;
    };
    constexpr double h = 1e-4;  // the slope's third derivative times h^2 is below 1e-8
    for (const double distance : {0.3, 0.6, 0.95})
        EXPECT_NEAR(-2 * pull<double>(forces, distance), (energy(distance + h) - energy(distance - h)) / (2 * h), 1e-8);
}

}  // namespace
}  // namespace steplab
