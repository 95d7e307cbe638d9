#include "core/flush_subnormals.hpp"
#include "core/lanes.hpp"
#include "models/forces/spring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace steplab::test {
namespace {

template <class T>
class Springs : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(Springs, Numbers);

/// Differences of displacements: of all orders of magnitude, springs compressed to almost zero length and reversed, and
/// the ends of the range.
template <class T>
std::vector<T> differences(T length) {
    using Limits = std::numeric_limits<T>;
    std::vector<T> all{0, -length, -2 * length, Limits::min(), Limits::max(), -Limits::max(), Limits::infinity()};
    std::mt19937 random(11);
    std::uniform_real_distribution<double> exponent(Limits::min_exponent, Limits::max_exponent), sign(-1, 1);
    for (int i = 0; i < 20000; ++i) {
        const T size = static_cast<T>(std::copysign(std::exp2(exponent(random)), sign(random)));
        all.insert(all.end(), {size, size - length, length * static_cast<T>(3 * sign(random))});
    }
    return all;
}

template <class T>
bool same(T a, T b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

// The root of a square is exactly the absolute value (S. Boldo, Stupid is as stupid does: taking the square root of the
// square of a floating-point number, 2015); where the square is too large or small for a number, the pull does not
// depend on the root.
TYPED_TEST(Springs, along_x_pull_as_others_do) {
    using T = TypeParam;
    const FlushSubnormals flush;
    for (const T length : {T(2), T(0.7), T(0)}) {
        const Offset<T, Zero, Zero> rest{length, {}, {}};
        bool turned_matters = false;
        for (const T e : differences(length)) {
            const auto along = SpringGeometry<T>::along_x(length, e);
            const Vector<T> expected = spring_pull(SpringGeometry<T>(rest, {e, 0, 0}), length, T(3));
            EXPECT_TRUE(same(spring_pull(along, length, T(3)).x, expected.x)) << e;
            auto partner = along;
            partner.distance = along.d.x;
            turned_matters = turned_matters || !same(spring_pull(partner, length, T(3)).x, expected.x);
        }
        EXPECT_EQ(turned_matters, length > 0) << "the partner";
    }
}

// For lanes as for single numbers, zeros included.
TYPED_TEST(Springs, absolute_values_of_lanes_are_those_of_numbers) {
    using N = Lanes<TypeParam>;
    for (const TypeParam number :
         {TypeParam(-2.5), TypeParam(3), TypeParam(0), TypeParam(-0.0), -std::numeric_limits<TypeParam>::infinity()}) {
        const N size = magnitude(N(number));
        for (std::size_t lane = 0; lane < N::count; ++lane) EXPECT_EQ(size[lane], std::abs(number));
    }
    EXPECT_FALSE(magnitude(N(std::numeric_limits<TypeParam>::quiet_NaN()))[0] > 0);
}

}  // namespace
}  // namespace steplab::test
