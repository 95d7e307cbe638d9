#include "methods/velocity-verlet.hpp"
#include "support/oscillator_theory.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::test {
namespace {

constexpr double dt = 0.1;
constexpr std::uint64_t steps[] = {10'000'000};

/// 10^7 steps of the oscillator against the 10^7th power of the map that one of `theory_dt` is.
Deviation after_long(Precision precision, bool compensated, double theory_dt) {
    return deviations(oscillator("velocity-verlet", precision, dt, compensated), step_map<VelocityVerlet>(theory_dt),
                      steps)
        .front();
}

// Every step rounds x and v by some 1e-16 of them, mostly to both sides: 1e-16 sqrt(10^7) = 4e-13, and a part of it to
// one side, which products of dt repeat. Compensated, that part is what is left. The partner: theory of a dt that is
// one rounding off, 1e7 times.
TEST(LongTime, oscillator_in_double_is_where_theory_says) {
    const Deviation plain = after_long(Precision::double_, false, dt), sums = after_long(Precision::double_, true, dt);
    EXPECT_LT(std::abs(plain.phase), 5e-11);
    EXPECT_LT(std::abs(plain.energy), 5e-11);
    EXPECT_LT(std::abs(sums.phase), 5e-12);
    EXPECT_LT(std::abs(sums.energy), 1e-12);
    EXPECT_GT(std::abs(after_long(Precision::double_, true, std::nextafter(dt, 1)).phase), 5e-11);
}

// The same with half an ulp of 6e-8. The partner: theory of 0.1, which is not float(0.1), is off by 1.5e-9 a step.
TEST(LongTime, oscillator_in_float_is_where_theory_says_for_its_own_dt) {
    constexpr double held = static_cast<double>(0.1f);
    const Deviation plain = after_long(Precision::float_, false, held),
                    sums = after_long(Precision::float_, true, held);
    EXPECT_LT(std::abs(plain.phase), 5e-3);
    EXPECT_LT(std::abs(sums.phase), 5e-3);
    EXPECT_LT(std::abs(sums.energy), std::abs(plain.energy));
    EXPECT_LT(std::abs(sums.energy), 2e-5);
    EXPECT_GT(std::abs(after_long(Precision::float_, true, dt).phase), 1e-2);
}

// Where the map itself is known in closed form, cos(angle of a step) = 1 - dt^2 / 2.
TEST(LongTime, theory_is_the_closed_form) {
    const Map map = step_map<VelocityVerlet>(0.1L);
    EXPECT_NEAR(static_cast<double>((map.xx + map.vv) / 2 - (1 - 0.1L * 0.1L / 2)), 0, 1e-18);
    EXPECT_NEAR(static_cast<double>(map.xx * map.vv - map.xv * map.vx - 1), 0, 1e-18);
}

}  // namespace
}  // namespace steplab::test
