#include "models/potentials/softened.hpp"

#include "core/dual.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace steplab::test {
namespace {

// Distances in metres of planets and of atoms: their third powers leave the range of float, forces do not. Four
// operations of half an ulp each.
/// False where float does not hold the factor.
template <class T>
bool expect_factors(double strength, double r) {
    const SoftenedInverse<T> potential(strength, 0);
    const double right = strength / (r * r * r);
    if (!(right > 1e2 * static_cast<double>(std::numeric_limits<T>::min()) && right < 1e36)) return false;
    const T squared = static_cast<T>(r) * static_cast<T>(r);
    const T factor = potential.factor(PairDistance<T>{squared});
    EXPECT_NEAR(static_cast<double>(factor) / right, 1, 4 * std::numeric_limits<T>::epsilon()) << strength << ", " << r;
    const T tiny = static_cast<T>(1e-15);
    EXPECT_NEAR(
        static_cast<double>(SoftenedInverse<T>(strength * 1e-15, 0).factor(PairDistance<T>{squared}, 1 / tiny)) / right,
        1, 8 * std::numeric_limits<T>::epsilon())
        << "the weight comes before the powers of the distance";
    // slopes: of 1 / r by r^2 it is 1 / r^3
    const double steepest = right / (r * r);
    if (!(r * r * r > 1e-36 && r * r * r < 1e36 && steepest < 1e36 && steepest > 1e-36)) return true;
    const Dual<T> slope = potential.factor(PairDistance<Dual<T>>{{squared, T(1)}});
    EXPECT_EQ(slope.value, factor);
    EXPECT_NEAR(static_cast<double>(slope.derivative) * r * r / right, -1.5, 20 * std::numeric_limits<T>::epsilon())
        << strength << ", " << r;
    return true;
}

TEST(SoftenedInverse, is_right_over_the_range_of_distances_that_float_can_square) {
    int tried = 0;
    for (double r = 1e-15; r < 1e18; r *= 10) {
        for (double strength = 1e-20; strength < 1e37; strength *= 1e3) {
            if (expect_factors<float>(strength, 1.37 * r)) ++tried;
            expect_factors<double>(strength, 1.37 * r);
        }
    }
    EXPECT_GT(tried, 200);
}

}  // namespace
}  // namespace steplab::test
