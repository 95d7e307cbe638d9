#pragma once

#include <charconv>
#include <string>

namespace steplab {

/// Appends the shortest text that reads back as the same number, in the C locale.
template <class Number>
void append_number(std::string& text, Number value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    text.append(digits, end);
}

}  // namespace steplab
