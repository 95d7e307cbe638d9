#include "core/team.hpp"
#include "models/clusters.hpp"
#include "models/layouts.hpp"
#include "models/plain.hpp"
#include "sim/catalogue.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <tuple>

namespace steplab::test {
namespace {

ParameterValues values(Settings settings) {
    ParameterValues all(model("crystal").info.parameters);
    for (const auto& [name, value] : settings) all.set(name, value);
    return all;
}
Scene crystal(Settings settings = {}) { return model("crystal").scene(values(settings)); }

NearPairForces forces_of(const Scene& scene) { return std::get<NearPairForces>(scene.forces); }

/// Far from the lattice, and some of them periods away.
template <class T>
Field<T> scattered(const Scene& scene, double spread) {
    Field<double> u = scene.start.state().displacement;
    const double period = forces_of(scene).period;
    for (std::size_t i = 0; i < u.count(); ++i) {
        const auto along = [&](std::size_t n) { return spread * (static_cast<double>(n * 37 % 101) / 50 - 1); };
        const auto away = [&](std::size_t n) { return period * (static_cast<double>(n % 5) - 2); };
        u.set(i,
              u.at(i) + Vec3{along(3 * i) + away(i), along(3 * i + 1) + away(i / 3), along(3 * i + 2) + away(i / 7)});
    }
    return converted<T>(u);
}

/// Largest difference from the plain loop over all pairs, which takes nearest images; in parts of the largest number.
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

/// Positions up to 20 leave a distance an error of 20 eps, which b = 5 and the slope of the force multiply, in some
/// forty pairs.
template <class T>
constexpr double tolerance = 5000 * static_cast<double>(std::numeric_limits<T>::epsilon());

template <class T>
class CrystalForces : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(CrystalForces, Numbers);

TYPED_TEST(CrystalForces, are_those_of_all_nearest_images) {
    for (const double edge : {5.0, 6.0, 9.0}) {
        for (const double spread : {0.05, 0.3, 2.0}) {
            const Scene scene = crystal({{"edge", edge}});
            const Field<TypeParam> u = scattered<TypeParam>(scene, spread);
            EXPECT_LT(worst(forces_of(scene), forces_of(scene), u), tolerance<TypeParam>) << edge << " " << spread;
        }
    }
}

TYPED_TEST(CrystalForces, are_not_those_of_a_period_or_cut_off_slightly_different) {
    const Scene scene = crystal();
    const Field<TypeParam> u = scattered<TypeParam>(scene, 0.05);
    NearPairForces other = forces_of(scene);
    other.period *= 1.01;
    EXPECT_GT(worst(forces_of(scene), other, u), tolerance<TypeParam>);
    other = forces_of(scene);
    other.cutoff *= 0.8;
    EXPECT_GT(worst(forces_of(scene), other, u), tolerance<TypeParam>);
}

TYPED_TEST(CrystalForces, add_up_to_nothing) {
    const Scene scene = crystal();
    Field<TypeParam> a(forces_of(scene).count);
    NearPairs<TypeParam>(forces_of(scene)).accelerations(scattered<TypeParam>(scene, 0.1), a);
    for (const TypeParam* along : {a.x(), a.y(), a.z()}) {
        double sum = 0, sizes = 0;
        for (std::size_t i = 0; i < a.count(); ++i) {
            sum += static_cast<double>(along[i]);
            sizes += static_cast<double>(std::abs(along[i]));
        }
        // a rounding of each of some forty pulls at a particle
        EXPECT_LT(std::abs(sum), 40 * static_cast<double>(std::numeric_limits<TypeParam>::epsilon()) * sizes);
    }
}

// Whenever its lists are made anew, a run finds all pairs: as many as lists made at each step.
TYPED_TEST(CrystalForces, come_from_lists_that_hold_until_they_are_renewed) {
    const Scene scene = crystal({{"m", 1}});
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
            // the same pulls in another order: forty below 100
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

/// Calls f(slab, cluster, others) for all clusters.
template <class F>
void each_row(const Clusters& clusters, F f) {
    for (std::size_t slab = 0; slab < clusters.slabs().size(); ++slab) {
        clusters.each(clusters.slabs()[slab], [&](std::uint32_t cluster, std::span<const Clusters::Other> others) {
            f(slab, cluster, others);
        });
    }
}

// So slabs of even numbers can be summed at the same time, and then those of odd ones. Images along x, which a slab far
// away may have, are of the first one alone.
TEST(Clusters, are_in_slabs_that_meet_only_the_next_one) {
    for (const double period : {0.0, 17.0, 18.0}) {
        for (const double reach : {1.2, 2.3, 4.0}) {
            const Scene scene = crystal({{"edge", 17}});
            Field<double> u = scattered<double>(scene, 0.4);
            for (double& number : u.flat()) number -= period > 0 ? period * std::round(number / period) : 0;
            Clusters clusters;
            Team alone(1);
            clusters.make(
                u.count(), [&](std::size_t i) { return u.at(i); }, reach, period, alone);
            const auto slabs = clusters.slabs();
            ASSERT_GE(slabs.size(), 4u);
            std::uint32_t rows = 0;
            each_row(clusters, [&](std::size_t slab, std::uint32_t cluster, const auto& others) {
                EXPECT_EQ(cluster, rows++);
                for (const Clusters::Other other : others) {
                    if (Clusters::periods(other.image(), 0) != 0) {
                        EXPECT_EQ(slab, 0u);
                    } else {
                        EXPECT_GE(other.cluster(), slabs[slab].begin);
                        EXPECT_LT(other.cluster(), slabs[std::min(slab + 1, slabs.size() - 1)].end);
                    }
                }
            });
            EXPECT_EQ(rows, clusters.count());
        }
    }
}

// More members than a power of two, and than particles; some particles are nowhere.
TEST(Clusters, are_the_same_whoever_sorts) {
    for (const double edge : {1.0, 6.0, 17.0}) {
        const Scene scene = crystal({{"edge", edge}, {"cutoff", edge / 3}});
        Field<double> u = scattered<double>(scene, 0.4);
        if (edge > 1) u.set(100, {0, std::numeric_limits<double>::quiet_NaN(), 0});
        if (edge > 1) u.set(7, {std::numeric_limits<double>::infinity(), 0, 0});
        const auto places = [&](std::size_t members) {
            Team team(members);
            Clusters clusters;
            clusters.make(
                u.count(), [&](std::size_t i) { return u.at(i); }, 2.3, 0, team);
            return std::vector<std::uint32_t>(clusters.places().begin(), clusters.places().end());
        };
        const auto alone = places(1);
        for (const std::size_t members : {2u, 3u, 4u, 7u}) EXPECT_EQ(places(members), alone) << edge << " " << members;
    }
}

TEST(Clusters, list_each_pair_within_reach_once) {
    for (const double period : {0.0, 5.0, 8.0}) {
        const Scene scene = crystal({{"edge", 6}});
        Field<double> u = scattered<double>(scene, 0.4);
        const auto nearest = [=](double d) { return period > 0 ? d - period * std::round(d / period) : d; };
        for (double& number : u.flat()) number = nearest(number);
        Clusters clusters;
        Team alone(1);
        clusters.make(
            u.count(), [&](std::size_t i) { return u.at(i); }, 2.3, period, alone);
        std::vector<std::size_t> particle(clusters.count() * Clusters::size, u.count());
        for (std::size_t i = 0; i < u.count(); ++i) particle[clusters.places()[i]] = i;
        std::set<std::pair<std::size_t, std::size_t>> found;
        const auto look = [&](std::size_t c, Clusters::Other other) {
            const auto along = [&](std::size_t axis) { return period * Clusters::periods(other.image(), axis); };
            const bool itself = c == other.cluster() && other.image() == Clusters::own_image;
            for (std::size_t p = 0; p < Clusters::size; ++p) {
                for (std::size_t q = itself ? p + 1 : 0; q < Clusters::size; ++q) {
                    const std::size_t i = particle[c * Clusters::size + p];
                    const std::size_t j = particle[other.cluster() * Clusters::size + q];
                    if (i == u.count() || j == u.count()) continue;
                    const Vec3 image = u.at(j) + Vec3{along(0), along(1), along(2)};
                    if (!(length(image - u.at(i)) < 2.3)) continue;
                    EXPECT_TRUE(found.emplace(std::min(i, j), std::max(i, j)).second) << period;
                }
            }
        };
        each_row(clusters, [&](std::size_t, std::uint32_t c, std::span<const Clusters::Other> others) {
            look(c, {c, Clusters::own_image});
            for (const Clusters::Other other : others) look(c, other);
        });
        std::size_t expected = 0;
        for (std::size_t i = 0; i < u.count(); ++i) {
            for (std::size_t j = i + 1; j < u.count(); ++j) {
                const Vec3 d = u.at(j) - u.at(i);
                expected += length({nearest(d.x), nearest(d.y), nearest(d.z)}) < 2.3 ? 1 : 0;
            }
        }
        EXPECT_EQ(found.size(), expected) << period;
    }
}

TEST(Clusters, survive_particles_that_are_nowhere) {
    Field<double> u(6);
    u.set(1, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
    u.set(2, {1e300, -1e300, 0});
    u.set(3, {1e30, 0, 0});
    u.set(4, {0.5, 0, 0});
    const NearPairForces forces{{.count = 6}, 1};
    Field<double> a(6);
    NearPairs<double>(forces).accelerations(u, a);
    for (const std::size_t i : {1u, 2u, 3u}) EXPECT_EQ(a.at(i), Vec3{}) << i;
    EXPECT_EQ(a.x()[0], a.x()[5]);  // at one place
}

TEST(Crystal, starts_without_momentum_and_as_warm_as_it_says) {
    const Scene scene = crystal({{"edge", 10}, {"kT", 0.3}, {"m", 2}});
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

TEST(Crystal, starts_otherwise_with_another_seed) {
    EXPECT_FALSE(crystal({{"seed", 1}}).start[5].displacement == crystal({{"seed", 2}}).start[5].displacement);
    EXPECT_FALSE(crystal({{"seed", 1}}).start[5].velocity == crystal({{"seed", 2}}).start[5].velocity);
    EXPECT_FALSE(crystal({{"seed", 1}}).start[5].displacement == crystal({{"seed", 16777215}}).start[5].displacement);
    EXPECT_EQ(crystal({{"jitter", 0}}).start[5].displacement, (Vec3{5, 0, 0}));
}

TEST(Crystal, is_refused_where_a_particle_would_meet_two_images_of_another) {
    const auto refused = [](Settings settings) { return model("crystal").refusal(values(settings)); };
    EXPECT_FALSE(refused({}));
    EXPECT_FALSE(refused({{"edge", 5}}));
    ASSERT_TRUE(refused({{"edge", 4}}));
    EXPECT_NE(refused({{"cutoff", 3.01}})->find("2.3 times the cutoff"), std::string::npos);
}

// Lists are part of the state: kept and brought back in the middle of a run, or looked at, it goes on with the same
// bits.
TEST(NearPairsRun, goes_on_with_the_same_bits_whoever_looks_or_comes_back) {
    for (const Precision precision : precisions) {
        const RunDescription description =
            run_of("morse", "velocity-verlet", precision, 0.02, {{"cutoff", 1}, {"edge", 5}, {"v0", 5}});
        Simulation undisturbed(description), looked(description), back(description);
        undisturbed.advance(200);
        for (int step = 0; step < 200; ++step) {
            looked.advance(1);
            looked.frame();
            looked.diagnostics();
        }
        EXPECT_EQ(looked.hash(), undisturbed.hash());
        back.advance(77);
        const auto kept = back.save();
        back.advance(60);
        back.restore(kept);
        back.advance(123);
        EXPECT_EQ(back.hash(), undisturbed.hash());
    }
}

}  // namespace
}  // namespace steplab::test
