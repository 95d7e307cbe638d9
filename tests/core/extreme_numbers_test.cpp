#include "core/number_text.hpp"
#include "core/ticks.hpp"
#include "support/extreme_doubles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace steplab {
namespace {

constexpr int random_pairs = 20000;

// Twice the 17 digits of a double, its sign, point and exponent, with room to spare.
constexpr std::size_t longest_text = 40;

TEST(ExtremeNumbers, ranges_are_finite_and_hold_their_values) {
    for (const auto& [a, b] : extreme_pairs(random_pairs)) {
        for (const int intervals : {1, 5}) {
            const Range range = nice_range(a, b, intervals);
            ASSERT_LT(range.low, range.high) << a << " .. " << b;
            ASSERT_TRUE(std::isfinite(range.low) && std::isfinite(range.high)) << a << " .. " << b;
            if (!std::isfinite(a) || !std::isfinite(b) || b < a) continue;
            // The ends are rounded: by parts of 1e-9 of an interval, and of themselves.
            const double slack = 1e-8 * (b / 2 - a / 2) + 1e-15 * std::max(std::abs(a), std::abs(b));
            ASSERT_LE(range.low, a + slack) << a << " .. " << b;
            ASSERT_GE(range.high, b - slack) << a << " .. " << b;
        }
        const Range decades_around = decade_range(a, b);
        ASSERT_LT(decades_around.low, decades_around.high) << a << " .. " << b;
        ASSERT_TRUE(std::isfinite(decades_around.high)) << a << " .. " << b;
    }
}

TEST(ExtremeNumbers, ticks_are_few_ascending_and_finite) {
    for (const auto& [a, b] : extreme_pairs(random_pairs)) {
        const double step = nice_step(a, b, 5);
        const auto ticks = linear_ticks(a, b, step);
        ASSERT_LE(ticks.size(), 6u) << a << " .. " << b;
        ASSERT_TRUE(std::is_sorted(ticks.begin(), ticks.end()));
        ASSERT_EQ(std::adjacent_find(ticks.begin(), ticks.end()), ticks.end()) << a << " .. " << b;
        for (const double tick : ticks) {
            ASSERT_TRUE(std::isfinite(tick)) << a << " .. " << b;
            ASSERT_LE(tick_text(tick, step, std::max(std::abs(a), std::abs(b))).size(), longest_text);
        }
        ASSERT_LE(linear_ticks(a, b, std::abs(b)).size(), 1001u);
        ASSERT_LE(decades(a, b).size(), 632u);
        ASSERT_LE(tick_text(a, b, std::abs(a)).size(), longest_text) << a << " step " << b;
    }
}

TEST(ExtremeNumbers, have_short_texts_and_no_sign_without_a_number) {
    for (const auto& [a, b] : extreme_pairs(random_pairs)) {
        for (const std::string& text : {number_text(a), readable(a), readable(a, 17), typed(a), typed(a, 6),
                                        setting_text(a), reading_text(a), rounded_text(a), short_number(a)}) {
            ASSERT_LE(text.size(), longest_text) << text;
            ASSERT_FALSE(text.empty());
            ASSERT_FALSE(std::isnan(a) && text.starts_with('-')) << text;
        }
        ASSERT_TRUE(!std::isfinite(a) || parse_number(number_text(a)) == a) << a;
    }
}

}  // namespace
}  // namespace steplab
