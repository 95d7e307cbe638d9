#pragma once

#include <optional>
#include <string_view>

namespace steplab {

/// The arithmetic of a whole run, dt and parameters included.
enum class Precision { float_, double_ };

constexpr std::string_view id(Precision precision) { return precision == Precision::float_ ? "float" : "double"; }

/// The precision of an id, none if it is not one.
constexpr std::optional<Precision> parse_precision(std::string_view text) {
    for (const Precision precision : {Precision::float_, Precision::double_}) {
        if (text == id(precision)) return precision;
    }
    return std::nullopt;
}

/// `value` rounded to this precision: unchanged in double, the nearest float in float. A value too large for float
/// becomes infinite.
double rounded_to(Precision precision, double value);

}  // namespace steplab
