#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace steplab::test {

/// Least contrast of texts and of graphics (WCAG 2, level AA).
inline constexpr double of_text = 4.5, of_shapes = 3;

/// Relative luminance of a colour in sRGB (WCAG 2).
inline double luminance(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    const auto linear = [](std::uint8_t channel) {
        const double v = channel / 255.0;
        return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
}

/// Of two luminances (WCAG 2): from 1, of equal ones, to 21.
inline double contrast(double one, double other) {
    return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

}  // namespace steplab::test
