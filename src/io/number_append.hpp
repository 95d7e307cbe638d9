#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>

namespace steplab {

/// The most characters of a number.
constexpr std::size_t most_digits = 32;

/// Writes the shortest text that reads back as the same number, in the C locale; "nan" whatever its sign. Returns its
/// end, at most `most_digits` further on.
template <class Number>
char* write_number(char* to, Number value) {
    if constexpr (std::is_floating_point_v<Number>) value = std::isnan(value) ? std::abs(value) : value;
    return std::to_chars(to, to + most_digits, value).ptr;
}

template <class Number>
void append_number(std::string& text, Number value) {
    char digits[most_digits];
    text.append(digits, write_number(digits, value));
}

}  // namespace steplab
