#include "models/forces/clusters.hpp"

#include "core/team.hpp"
#include "models/forces/cluster_pairs.hpp"
#include "models/forces/layouts.hpp"
#include "support/crystals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace steplab::test {
namespace {

/// Calls f(slab, cluster, others) for all clusters.
template <class F>
void each_row(const Clusters& clusters, F f) {
    for (std::size_t slab = 0; slab < clusters.slabs().size(); ++slab) {
        ClusterPairs(clusters).each(clusters.slabs()[slab],
                                    [&](std::uint32_t cluster, auto others) { f(slab, cluster, others); });
    }
}

// So slabs with even numbers can be summed in parallel, and then those with odd numbers. Only the first slab has images
// along x, which may belong to distant slabs.
TEST(Clusters, are_in_slabs_that_interact_only_with_the_next_one) {
    for (const double period : {0.0, 17.0, 18.0}) {
        for (const double reach : {1.2, 2.3, 4.0}) {
            const Plan scene = crystal({{"edge", 17}});
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

// Numbers of members that are no power of two, or exceed the number of particles; some particles have no valid
// position.
TEST(Clusters, do_not_depend_on_the_number_of_threads) {
    for (const double edge : {1.0, 6.0, 17.0}) {
        const Plan scene = crystal({{"edge", edge}, {"cutoff", edge / 3}});
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

// Sorting begins with the previous order: that of other positions, or of another number of particles.
TEST(Clusters, do_not_depend_on_previous_clusters) {
    Team team(3);
    const auto make = [&](Clusters& clusters, double edge, double spread) {
        const Field<double> u = scattered<double>(crystal({{"edge", edge}}), spread);
        clusters.make(
            u.count(), [&](std::size_t i) { return u.at(i); }, 2.3, 0, team);
        return std::vector<std::uint32_t>(clusters.places().begin(), clusters.places().end());
    };
    Clusters again;
    for (const auto& [edge, spread] : {std::pair{6.0, 0.1}, {6.0, 0.4}, {7.0, 0.4}, {5.0, 0.1}, {5.0, 2.0}}) {
        Clusters fresh;
        EXPECT_EQ(make(again, edge, spread), make(fresh, edge, spread)) << edge << " " << spread;
    }
}

TEST(Clusters, list_each_pair_within_reach_once) {
    for (const double period : {0.0, 5.0, 8.0}) {
        const Plan scene = crystal({{"edge", 6}});
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
        const auto list_pairs = [&](std::size_t c, Clusters::Other other) {
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
            list_pairs(c, {c, Clusters::own_image});
            for (const Clusters::Other other : others) list_pairs(c, other);
        });
        std::size_t expected = 0;
        for (std::size_t i = 0; i < u.count(); ++i) {
            for (std::size_t j = i + 1; j < u.count(); ++j) {
                const Vec3 d = u.at(j) - u.at(i);
                expected += length({nearest(d.x), nearest(d.y), nearest(d.z)}) < 2.3 ? 1 : 0;
            }
        }
        EXPECT_GT(expected, 0u) << period;
        EXPECT_EQ(found.size(), expected) << period;
    }
}

TEST(Clusters, accept_particles_without_a_valid_position) {
    Field<double> u(6);
    u.set(1, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
    u.set(2, {1e300, -1e300, 0});
    u.set(3, {1e30, 0, 0});
    u.set(4, {0.5, 0, 0});
    const NearPairForces forces{{.count = 6}, 1};
    Field<double> a(6);
    NearPairs<double>(forces).accelerations(u, a);
    for (const std::size_t i : {1u, 2u, 3u}) EXPECT_EQ(a.at(i), Vec3{}) << i;
    EXPECT_EQ(a.x()[0], a.x()[5]);  // at the same place
}

// Their distances overflow a float.
TEST(Clusters, accept_particles_whose_distance_overflows) {
    Field<float> u(3), a(3);
    u.set(0, {0, 0, -3e38});
    for (const std::size_t i : {1u, 2u}) u.set(i, {0, 0, 3e38});
    NearPairs<float>(NearPairForces{{.count = 3}, 1}).accelerations(u, a);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(a.at(i), Vec3{}) << i;
}

}  // namespace
}  // namespace steplab::test
