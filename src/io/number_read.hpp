#pragma once

#include "core/shown.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace steplab {

/// The whole word as a number that is finite, in the C locale; none if it is not one.
template <class Number>
std::optional<Number> number_in(std::string_view word) {
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    if constexpr (std::is_floating_point_v<Number>) {
        if (!std::isfinite(value)) return std::nullopt;
    }
    return value;
}

/// Why a word was refused that should be one.
inline std::string no_number_text(std::string_view word) {
    return fmt::format("\"{}\" is not a number that can stand here", shown(word));
}

}  // namespace steplab
