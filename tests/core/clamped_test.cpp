#include "core/clamped.hpp"

#include "support/extreme_doubles.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <limits>

namespace steplab {
namespace {

TEST(clamped_floor, is_the_whole_number_below_within_its_bounds) {
    EXPECT_EQ(clamped_floor(2.9, 0, 5), 2);
    EXPECT_EQ(clamped_floor(-0.1, -3, 5), -1);
    EXPECT_EQ(clamped_floor(5.0, 0, 5), 5);
    EXPECT_EQ(clamped_floor(7, 0, 5), 5);
    EXPECT_EQ(clamped_floor(-7, 0, 5), 0);
}

TEST(clamped_floor, has_a_value_for_every_double) {
    using Limits = std::numeric_limits<double>;
    for (const double x : {Limits::quiet_NaN(), -Limits::infinity(), -1e300}) EXPECT_EQ(clamped_floor(x, 1, 9), 1) << x;
    for (const double x : {Limits::infinity(), 1e300, 1e10}) EXPECT_EQ(clamped_floor(x, 1, 9), 9) << x;
}

/// Of any type of whole numbers, to its ends.
template <class Integer>
void expect_within(Integer low, Integer high) {
    for (const auto& [a, b] : extreme_pairs(2000)) {
        for (const double x : {a, b}) {
            const Integer found = clamped_floor<Integer>(x, low, high);
            EXPECT_GE(found, low);
            EXPECT_LE(found, high);
            if (x > static_cast<double>(low) && x < static_cast<double>(high)) {
                EXPECT_EQ(static_cast<double>(found), std::floor(x));
            }
        }
    }
}

TEST(clamped_floor, is_within_its_bounds_for_every_type) {
    expect_within<int>(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
    expect_within<std::int64_t>(-9'000'000'000'000'000, 9'000'000'000'000'000);
    expect_within<std::uint64_t>(1, std::uint64_t{1} << 63);
}

TEST(clamped_seconds, are_none_or_as_many_as_asked_for) {
    using std::chrono::duration;
    EXPECT_EQ(duration<double>(clamped_seconds(0.25, 10)).count(), 0.25);
    EXPECT_EQ(duration<double>(clamped_seconds(12, 10)).count(), 10);
    for (const auto& [a, b] : extreme_pairs(200)) {
        const auto found = clamped_seconds(a / b, 1e8);
        EXPECT_GE(found.count(), 0);
        EXPECT_LE(duration<double>(found).count(), 1e8);
        if (a / b > 1e8) {
            EXPECT_EQ(duration<double>(found).count(), 1e8);
        }
    }
}

}  // namespace
}  // namespace steplab
