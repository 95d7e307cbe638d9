#include "models/forces/pairs.hpp"

#include "core/stages.hpp"
#include "models/forces/pair_block.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <vector>

namespace steplab::test {
namespace {

// including more blocks than are computed at a time
constexpr std::array<std::size_t, 14> counts{1, 2, 3, 4, 5, 7, 8, 9, 16, 17, 28, 33, 50, 90};

/// Particles at random positions in a box with the volume of a sphere of r0 for each.
template <class T>
Field<T> places(std::size_t count) {
    std::mt19937 random(static_cast<unsigned>(count));
    std::uniform_real_distribution<double> along(0, 0.5 * std::cbrt(static_cast<double>(count)));
    Field<T> field(count);
    for (std::size_t i = 0; i < count; ++i) field.set(i, {along(random), along(random), along(random)});
    return field;
}

template <class T>
Field<T> pulls(const Field<T>& u, PairForces forces = {}) {
    forces.count = u.count();
    Field<T> a(u.count());
    Pairs<T>(forces).accelerations(u, a);
    return a;
}

template <class T>
class PairSums : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(PairSums, Numbers);

/// The acceleration of particle i by all others in order, in long double, with a force constant larger by the factor
/// `stiffer`.
template <class T>
Vec3 plain_sum(const Field<T>& u, std::size_t i, double stiffer) {
    const auto morse = morse_constants<long double>({.k = 0.5 * stiffer});
    Vector<long double> sum{0, 0, 0};
    for (std::size_t j = 0; j < u.count(); ++j) {
        const Vector<long double> d{static_cast<long double>(u.x()[i]) - u.x()[j],
                                    static_cast<long double>(u.y()[i]) - u.y()[j],
                                    static_cast<long double>(u.z()[i]) - u.z()[j]};
        if (j == i) continue;
        const long double r = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z), e = std::exp(morse.b * (morse.r0 - r));
        sum = sum + (morse.strength * e * (e - 1) / r) * d;
    }
    return {static_cast<double>(sum.x), static_cast<double>(sum.y), static_cast<double>(sum.z)};
}

template <class T>
double worst_error(std::size_t count, double stiffer) {
    const Field<T> u = places<T>(count), a = pulls(u);
    double worst = 0;
    for (std::size_t i = 0; i < count; ++i) worst = std::max(worst, length(a.at(i) - plain_sum(u, i, stiffer)));
    return worst;
}

// A pull is at most 2 b D / m e (e - 1) = 0.3 with e = exp(b r0) = 1.3, and takes about 15 roundings.
TYPED_TEST(PairSums, agree_with_the_plain_loop) {
    constexpr double rounding = std::numeric_limits<TypeParam>::epsilon();
    for (const std::size_t count : counts)
        EXPECT_LE(worst_error<TypeParam>(count, 1), 15 * 0.3 * rounding * static_cast<double>(count)) << count;
}

TYPED_TEST(PairSums, of_other_forces_do_not) {
    constexpr double rounding = std::numeric_limits<TypeParam>::epsilon();
    for (const std::size_t count : std::span(counts).subspan(1)) {  // one particle has no force
        EXPECT_GT(worst_error<TypeParam>(count, 1 + 1000 * rounding), 15 * 0.3 * rounding * static_cast<double>(count))
            << count;
    }
}

/// The order of the sums as docs/arithmetic.md states it, pair by pair.
template <class T>
Field<T> in_the_stated_order(const Field<T>& u, std::size_t block) {
    const MorseConstants<T> morse = morse_constants<T>(PairForces{});
    const auto pull = [&](std::size_t i, std::size_t j) {
        return morse_pull(morse, Vector<T>{u.x()[i] - u.x()[j], u.y()[i] - u.y()[j], u.z()[i] - u.z()[j]});
    };
    const Vector<T> none{T(0), T(0), T(0)};
    Field<T> a(u.count());
    for (std::size_t i = 0; i < u.count(); ++i) {
        const std::size_t first = i / block * block, place = i - first;
        const auto ahead = [&](std::size_t from, std::size_t s) {
            const std::size_t p = first + from, q = first + (from + s) % block;
            return p < u.count() && q < u.count() ? pull(p, q) : none;
        };
        Vector<T> sum = none;
        for (std::size_t s = 1; s < block / 2; ++s)
            sum = sum + (ahead(place, s) - ahead((place + block - s) % block, s));
        sum = sum + ahead(place, block / 2);
        std::vector<Vector<T>> places(block, none);
        for (std::size_t j = 0; j < first; ++j) places[j % block] = places[j % block] + pull(i, j);
        for (std::size_t half = block / 2; half > 0; half /= 2) {
            for (std::size_t l = 0; l < half; ++l) places[l] = places[l] + places[l + half];
        }
        sum = sum + places[0];
        for (std::size_t j = first + block; j < u.count(); ++j) sum = sum - pull(j, i);
        a.x()[i] = sum.x, a.y()[i] = sum.y, a.z()[i] = sum.z;
    }
    return a;
}

template <class T>
bool same(const Field<T>& a, const Field<T>& b) {
    return std::equal(a.flat().begin(), a.flat().end(), b.flat().begin());
}

TYPED_TEST(PairSums, have_the_stated_order_whatever_the_registers) {
    using T = TypeParam;
    for (const std::size_t count : counts) {
        const Field<T> u = places<T>(count), a = pulls(u);
        EXPECT_TRUE(same(a, in_the_stated_order(u, 64 / sizeof(T)))) << count;
    }
    const Field<T> u = places<T>(50);
    EXPECT_FALSE(same(pulls(u), in_the_stated_order(u, 32 / sizeof(T)))) << "these places do not show an order";
}

TYPED_TEST(PairSums, in_lanes_are_those_of_each_single_number) {
    using T = TypeParam;
    for (const std::size_t count : counts) {
        const Field<T> u = places<T>(count), a = pulls(u);
        Field<Stages<T>> lanes(count);
        for (std::size_t k = 0; k < u.flat().size(); ++k) lanes.flat()[k] = Stages<T>(u.flat()[k]);
        const Field<Stages<T>> sums = pulls(lanes);
        for (std::size_t k = 0; k < u.flat().size(); ++k) ASSERT_EQ(sums.flat()[k][5], a.flat()[k]) << count;
    }
}

// Each pull is added once and subtracted once: only the roundings of sums below 0.3 per particle remain.
TYPED_TEST(PairSums, conserve_momentum) {
    constexpr double rounding = std::numeric_limits<TypeParam>::epsilon();
    for (const std::size_t count : counts) {
        const Field<TypeParam> a = pulls(places<TypeParam>(count));
        Vec3 sum;
        for (std::size_t i = 0; i < count; ++i) sum = sum + a.at(i);
        EXPECT_LE(length(sum), 0.3 * rounding * static_cast<double>(count * count)) << count;
    }
}

TYPED_TEST(PairSums, of_coincident_particles_are_zero) {
    for (const std::size_t count : counts) {
        Field<TypeParam> u(count);
        for (std::size_t i = 0; i < count; ++i) u.set(i, {1, 2, 3});
        const Field<TypeParam> a = pulls(u);
        for (const TypeParam number : a.flat()) ASSERT_EQ(number, 0) << count;
    }
}

TYPED_TEST(PairSums, of_particles_too_far_apart_for_their_squares_are_zero) {
    Field<TypeParam> u(3);
    u.set(1, {static_cast<double>(std::numeric_limits<TypeParam>::max()) / 4, 0, 0});
    u.set(2, {0, static_cast<double>(std::numeric_limits<TypeParam>::max()) / 4, 0});
    const Field<TypeParam> a = pulls(u);
    for (const TypeParam number : a.flat()) EXPECT_EQ(number, 0);
}

}  // namespace
}  // namespace steplab::test
