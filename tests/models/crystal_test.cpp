#include "core/flush_subnormals.hpp"
#include "models/forces/layouts.hpp"
#include "models/forces/plain.hpp"
#include "support/crystals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace steplab::test {
namespace {

/// Largest difference from the plain loop over all pairs with nearest images, relative to the largest component.
template <class T>
double worst(const NearPairForces& forces, const NearPairForces& plain, const Field<T>& u) {
    Field<T> a(u.count()), expected(u.count());
    NearPairs<T>(forces).accelerations(u, a);
    Plain<T>(Forces(plain)).accelerations(u, expected);
    double difference = 0, largest = 1;
    for (std::size_t k = 0; k < a.flat().size(); ++k) {
        difference = std::max(difference, static_cast<double>(std::abs(a.flat()[k] - expected.flat()[k])));
        largest = std::max(largest, static_cast<double>(std::abs(expected.flat()[k])));
    }
    return difference / largest;
}

/// Positions up to 20 give a distance an error of 20 eps, which is amplified by b = 5 and the slope of the force, in
/// about forty pairs.
template <class T>
constexpr double tolerance = 5000 * static_cast<double>(std::numeric_limits<T>::epsilon());

template <class T>
class CrystalForces : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(CrystalForces, Numbers);

TYPED_TEST(CrystalForces, are_those_of_all_nearest_images) {
    for (const double edge : {5.0, 6.0, 9.0}) {
        for (const double spread : {0.05, 0.3, 2.0}) {
            const Plan scene = crystal({{"edge", edge}});
            const Field<TypeParam> u = scattered<TypeParam>(scene, spread);
            EXPECT_LT(worst(forces_of(scene), forces_of(scene), u), tolerance<TypeParam>) << edge << " " << spread;
        }
    }
}

TYPED_TEST(CrystalForces, are_not_those_of_a_period_or_cut_off_slightly_different) {
    const Plan scene = crystal();
    const Field<TypeParam> u = scattered<TypeParam>(scene, 0.05);
    NearPairForces other = forces_of(scene);
    other.period *= 1.01;
    EXPECT_GT(worst(forces_of(scene), other, u), tolerance<TypeParam>);
    other = forces_of(scene);
    other.cutoff *= 0.8;
    EXPECT_GT(worst(forces_of(scene), other, u), tolerance<TypeParam>);
}

TYPED_TEST(CrystalForces, sum_to_zero) {
    const Plan scene = crystal();
    Field<TypeParam> a(forces_of(scene).count);
    NearPairs<TypeParam>(forces_of(scene)).accelerations(scattered<TypeParam>(scene, 0.1), a);
    for (const TypeParam* along : {a.x(), a.y(), a.z()}) {
        double sum = 0, sizes = 0;
        for (std::size_t i = 0; i < a.count(); ++i) {
            sum += static_cast<double>(along[i]);
            sizes += static_cast<double>(std::abs(along[i]));
        }
        // one rounding for each of about forty pulls at a particle
        EXPECT_LT(std::abs(sum), 40 * static_cast<double>(std::numeric_limits<TypeParam>::epsilon()) * sizes);
    }
}

TYPED_TEST(CrystalForces, of_a_balanced_state_are_zero) {
    const Plan scene = crystal();
    const Field<TypeParam> u = scattered<TypeParam>(scene, 0.1);
    NearPairForces forces = forces_of(scene);
    Field<TypeParam> a(u.count());
    NearPairs<TypeParam>(forces).accelerations(u, a);
    Field<double> balance(u.count());
    for (std::size_t i = 0; i < u.count(); ++i) balance.set(i, a.at(i));
    forces.balance = std::make_shared<const Field<double>>(balance);
    NearPairs<TypeParam>(forces).accelerations(u, a);
    for (const TypeParam number : a.flat()) ASSERT_EQ(number, TypeParam(0));
}

// Lengths and energies times the same power of two: the same numbers. The squared lengths overflow or underflow the
// floats that lists are made with, or nearly do; runs flush subnormal numbers.
TYPED_TEST(CrystalForces, are_the_same_at_every_scale) {
    const FlushSubnormals flush;
    const Plan scene = crystal();
    const Field<TypeParam> u = scattered<TypeParam>(scene, 0.1);
    Field<TypeParam> expected(u.count());
    NearPairs<TypeParam>(forces_of(scene)).accelerations(u, expected);
    constexpr bool is_float = std::is_same_v<TypeParam, float>;
    for (const int power : {is_float ? -50 : -100, is_float ? 60 : 100}) {
        NearPairForces forces = forces_of(scene);
        const double length = std::ldexp(1, power);
        for (double* number : {&forces.r0, &forces.cutoff, &forces.period}) *number *= length;
        forces.depth *= length;
        forces.k /= length;
        Field<TypeParam> scaled = u, a(u.count());
        for (TypeParam& number : scaled.flat()) number *= static_cast<TypeParam>(length);
        NearPairs<TypeParam>(forces).accelerations(scaled, a);
        for (std::size_t k = 0; k < a.flat().size(); ++k)
            ASSERT_EQ(a.flat()[k], expected.flat()[k]) << power << " " << k;
    }
}

// With lists renewed from time to time, a run finds all pairs: as many as with lists made at each step.
TYPED_TEST(CrystalForces, come_from_lists_that_hold_until_they_are_renewed) {
    const Plan scene = crystal({{"m", 1}});
    State<TypeParam> state = scene.start.state<TypeParam>();
    NearPairs<TypeParam> followed(forces_of(scene));
    Field<TypeParam> a(state.displacement.count()), fresh(a.count()), last;
    int renewed = 0;
    for (int step = 0; step < 300; ++step) {
        followed.accelerations(state.displacement, a);
        NearPairs<TypeParam>(forces_of(scene)).accelerations(state.displacement, fresh);
        renewed += last.count() == 0 || followed.history().x()[0] != last.x()[0] ? 1 : 0;
        last = followed.history();
        for (std::size_t k = 0; k < a.flat().size(); ++k) {
            // the same pulls in another order: forty numbers below 100
            ASSERT_NEAR(a.flat()[k], fresh.flat()[k],
                        4000 * static_cast<double>(std::numeric_limits<TypeParam>::epsilon()))
                << step;
            state.velocity.flat()[k] += TypeParam(0.005) * a.flat()[k];
            state.displacement.flat()[k] += TypeParam(0.005) * state.velocity.flat()[k];
        }
    }
    EXPECT_GT(renewed, 5);
    EXPECT_LT(renewed, 100);
}

// Before the first evaluation, where the lists are valid, and where they are not.
TYPED_TEST(CrystalForces, are_observed_without_renewing_lists) {
    const Plan scene = crystal();
    const Field<TypeParam> u = scattered<TypeParam>(scene, 0.1), further = scattered<TypeParam>(scene, 0.4);
    NearPairs<TypeParam> forces(forces_of(scene));
    const auto observe = [&](const Field<TypeParam>& at) {
        Field<TypeParam> a(at.count()), expected(at.count());
        const Field<TypeParam> made_at = forces.history();
        forces.uncounted_accelerations(at, a);
        EXPECT_TRUE(std::ranges::equal(forces.history().flat(), made_at.flat()));
        NearPairs<TypeParam> fresh(forces_of(scene));
        fresh.accelerations(at, expected);
        EXPECT_TRUE(std::ranges::equal(a.flat(), expected.flat()));
    };
    observe(u);
    Field<TypeParam> a(u.count());
    forces.accelerations(u, a);
    observe(u);
    observe(further);
}

TEST(Crystal, starts_without_momentum_and_at_the_given_temperature) {
    const Plan scene = crystal({{"edge", 10}, {"kT", 0.3}, {"m", 2}});
    const State<double> state = scene.start.state();
    Vec3 sum;
    double squares = 0;
    for (std::size_t i = 0; i < 1000; ++i) {
        sum = sum + state.velocity.at(i);
        squares += dot(state.velocity.at(i), state.velocity.at(i));
    }
    EXPECT_LT(length(sum), 1e-12);  // a thousand roundings of numbers below 2
    // 3000 numbers: their variance is known to 2.6 % (one standard deviation)
    EXPECT_NEAR(squares / 3000, 0.15, 0.015);
}

TEST(Crystal, starts_differently_with_another_seed) {
    EXPECT_FALSE(crystal({{"seed", 1}}).start[5].displacement == crystal({{"seed", 2}}).start[5].displacement);
    EXPECT_FALSE(crystal({{"seed", 1}}).start[5].velocity == crystal({{"seed", 2}}).start[5].velocity);
    EXPECT_FALSE(crystal({{"seed", 1}}).start[5].displacement == crystal({{"seed", 16777215}}).start[5].displacement);
    EXPECT_EQ(crystal({{"jitter", 0}}).start[5].displacement, (Vec3{5, 0, 0}));
}

TEST(Crystal, is_refused_where_a_particle_would_interact_with_two_images_of_another) {
    const auto refused = [](Settings settings) { return model("crystal").refusal(values(settings)); };
    EXPECT_FALSE(refused({}));
    EXPECT_FALSE(refused({{"edge", 5}}));
    ASSERT_TRUE(refused({{"edge", 4}}));
    EXPECT_NE(refused({{"cutoff", 3.01}})->find("2.3 times the cutoff"), std::string::npos);
}

// Lists are part of the state: a run that is saved and restored, or observed, continues with the same bits.
TEST(NearPairsRun, continues_with_the_same_bits_after_observation_and_restoring) {
    for (const Precision precision : precisions) {
        const RunDescription description =
            run_of("morse", "velocity-verlet", precision, 0.02, {{"cutoff", 1}, {"edge", 5}, {"v0", 5}});
        Simulation undisturbed(description), observed(description), back(description);
        undisturbed.advance(200);
        for (int step = 0; step < 200; ++step) {
            observed.advance(1);
            observed.frame();
            observed.diagnostics();
        }
        EXPECT_EQ(observed.hash(), undisturbed.hash());
        back.advance(77);
        const auto saved = back.save();
        back.advance(60);
        back.restore(saved);
        back.advance(123);
        EXPECT_EQ(back.hash(), undisturbed.hash());
    }
}

}  // namespace
}  // namespace steplab::test
