#include "models/forces/layouts.hpp"
#include "models/forces/plain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

namespace steplab {
namespace {

// Particles are computed a register at a time: each size of a scene leaves a different remainder.

template <class T>
Field<T> scattered(std::size_t count, double size) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-size, size);
    Field<T> field(count);
    for (std::size_t i = 0; i < count; ++i) field.set(i, {place(random), place(random), place(random)});
    return field;
}

template <class T, class Forces>
Field<T> engine_accelerations(const Forces& forces, const Field<T>& u) {
    Field<T> a(u.count());
    engine<T>(forces).accelerations(u, a);
    return a;
}

/// The accelerations by the plain loop, on absolute positions.
template <class T, class Forces>
Field<T> plain_accelerations(const Forces& forces, const Field<T>& positions) {
    Field<T> a(positions.count());
    Plain<T>(forces).accelerations(positions, a);
    return a;
}

template <class T>
double largest_difference(const Field<T>& a, const Field<T>& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.flat().size(); ++k)
        largest = std::max(largest, static_cast<double>(std::abs(a.flat()[k] - b.flat()[k])));
    return largest;
}

template <class T>
class SizesTest : public testing::Test {
protected:
    /// Rounding of about ten operations on numbers up to 50, the positions of the largest grid.
    static constexpr double tolerance = 1000 * static_cast<double>(std::numeric_limits<T>::epsilon());

    static double worst_of_grid(std::size_t dim, double k) {
        const GridForces forces{.rows = dim, .columns = dim, .mass = 2, .k = 3, .rest_length = 1.5};
        GridForces other = forces;
        other.k = k;
        const Field<T> u = scattered<T>(dim * dim, 0.3);
        Field<T> positions = u;
        for (std::size_t p = 0; p < u.count(); ++p) {
            const auto row = static_cast<double>(p / dim), column = static_cast<double>(p % dim);
            positions.set(p, u.at(p) + Vec3{column * forces.rest_length, 0, -row * forces.rest_length});
        }
        return largest_difference(engine_accelerations(forces, u), plain_accelerations(other, positions));
    }

    static double worst_of_pairs(std::size_t count, double depth) {
        const PairForces forces{.count = count, .mass = 2, .depth = 1, .k = 0.5, .r0 = 0.5};
        PairForces other = forces;
        other.depth = depth;
        const Field<T> u = scattered<T>(count, 1);
        return largest_difference(engine_accelerations(forces, u), plain_accelerations(other, u));
    }
};

using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(SizesTest, Numbers);

TYPED_TEST(SizesTest, of_grids_agree_with_the_plain_loop) {
    for (std::size_t dim = 3; dim <= 20; ++dim) EXPECT_LT(this->worst_of_grid(dim, 3), this->tolerance) << dim;
    // several chunks, the last of them incomplete
    for (const std::size_t dim : {40u, 45u, 71u}) EXPECT_LT(this->worst_of_grid(dim, 3), 3 * this->tolerance) << dim;
}

TYPED_TEST(SizesTest, of_grids_with_springs_one_per_mille_stiffer_do_not) {
    for (std::size_t dim = 3; dim <= 20; ++dim) EXPECT_GT(this->worst_of_grid(dim, 3.003), this->tolerance) << dim;
}

TYPED_TEST(SizesTest, of_clusters_agree_with_the_plain_loop) {
    for (std::size_t count = 1; count <= 40; ++count)
        EXPECT_LT(this->worst_of_pairs(count, 1), this->tolerance) << count;
}

TYPED_TEST(SizesTest, of_clusters_one_per_cent_deeper_do_not) {
    for (std::size_t count = 2; count <= 40; ++count)
        EXPECT_GT(this->worst_of_pairs(count, 1.01), this->tolerance) << count;
}

// An additional particle so far away that its force is exactly zero may change the order of sums, and nothing else.
TYPED_TEST(SizesTest, of_clusters_do_not_matter_beyond_the_order_of_sums) {
    using T = TypeParam;
    for (std::size_t count = 2; count <= 33; ++count) {
        PairForces forces{.count = count};
        const Field<T> u = scattered<T>(count, 1);
        Field<T> more(count + 1);
        for (std::size_t i = 0; i < count; ++i) more.set(i, u.at(i));
        more.set(count, {1e5, 0, 0});
        const Field<T> a = engine_accelerations(forces, u);
        forces.count = count + 1;
        const Field<T> with_more = engine_accelerations(forces, more);
        for (std::size_t i = 0; i < count; ++i) EXPECT_LT(length(a.at(i) - with_more.at(i)), this->tolerance) << count;
        EXPECT_EQ(with_more.at(count), Vec3{});
    }
}

TYPED_TEST(SizesTest, of_clusters_with_coincident_particles_stay_finite) {
    using T = TypeParam;
    for (std::size_t count = 2; count <= 33; ++count) {
        Field<T> u = scattered<T>(count, 1);
        u.set(count - 1, u.at(0));
        const Field<T> a = engine_accelerations(PairForces{.count = count}, u);
        for (const T number : a.flat()) ASSERT_TRUE(std::isfinite(number)) << count;
        const double apart = length(a.at(0) - a.at(count - 1));
        EXPECT_LT(apart, this->tolerance) << count;  // the others pull both equally
    }
}

}  // namespace
}  // namespace steplab
