#include "ui/widgets/slider.hpp"

#include "support/extreme_doubles.hpp"
#include "ui/widgets/format.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::ui {
namespace {

TEST(slider, has_a_place_for_every_value_and_a_value_at_every_place) {
    for (const auto& [a, b] : extreme_pairs(2000)) {
        for (const bool logarithmic : {false, true}) {
            if (!std::isfinite(a) || !std::isfinite(b) || b < a || (logarithmic && !(a > 0))) continue;
            const SliderRange range{a, b, logarithmic, false};
            for (const double part : {0.0, 1e-9, 0.3, 0.5, 1.0}) {
                const double value = range.value(part);
                ASSERT_GE(value, a);
                ASSERT_LE(value, b);
            }
            for (const double value : special_doubles()) {
                const double part = range.part(value);
                ASSERT_GE(part, 0) << a << " .. " << b << " at " << value;
                ASSERT_LE(part, 1) << a << " .. " << b << " at " << value;
            }
        }
    }
}

TEST(slider, places_and_values_are_inverse) {
    for (const SliderRange& range :
         {SliderRange{0.01, 1000, true, false}, SliderRange{-5, 5, false, false},
          SliderRange{1e-300, 1e300, true, false}, SliderRange{-1e308, 1e308, false, false}}) {
        // Values have three digits: a part in 200 of themselves, or of the range.
        for (const double part : {0.1, 0.5, 0.9}) EXPECT_NEAR(range.part(range.value(part)), part, 0.005);
    }
}

TEST(slider, rounding_for_it_moves_a_value_by_less_than_a_pixel) {
    for (const auto& [value, end] : extreme_pairs(2000)) {
        if (!std::isfinite(value)) continue;
        const double rounded = rounded_for_slider(value, 0, std::abs(end), true);
        ASSERT_TRUE(std::isfinite(rounded) || std::abs(value) > 1e308) << value;
        ASSERT_LE(std::abs(rounded / 2 - value / 2), 0.005 * std::abs(value / 2)) << value;
        if (!std::isfinite(end) || std::abs(value) > std::abs(end)) continue;
        ASSERT_LE(std::abs(rounded_for_slider(value, 0, std::abs(end), false) / 2 - value / 2),
                  0.005 * std::abs(end / 2))
            << value << " in 0 .. " << end;
    }
}

TEST(slider, times_have_short_texts) {
    for (const auto& [time, dt] : extreme_pairs(2000)) {
        ASSERT_LE(time_text(time, dt).size(), 30u) << time << " " << dt;
        ASSERT_LE(vector({time, dt, -time}).size(), 60u);
    }
}

}  // namespace
}  // namespace steplab::ui
