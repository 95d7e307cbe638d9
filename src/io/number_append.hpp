#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <type_traits>

namespace steplab {

/// Appends the shortest text that reads back as the same number, in the C locale; "nan" whatever its sign.
template <class Number>
void append_number(std::string& text, Number value) {
    if constexpr (std::is_floating_point_v<Number>) value = std::isnan(value) ? std::abs(value) : value;
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    text.append(digits, end);
}

}  // namespace steplab
