#include "io/short_number.hpp"

#include <fmt/format.h>

#include <cmath>

namespace steplab {

std::string short_number(double value) {
    const bool has_long_integer_part = std::abs(value) >= 1000 && std::abs(value) < 1e7;
    return has_long_integer_part ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}

}  // namespace steplab
