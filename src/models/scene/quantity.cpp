#include "models/scene/quantity.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

namespace steplab {

namespace {

std::string written(const Quantity& quantity) {
    return quantity.text.empty() ? number_text(quantity.value) : quantity.text;
}

/// In brackets where it is more than a name or a number.
std::string as_factor(const Quantity& quantity) {
    const std::string text = written(quantity);
    return text.find_first_of("+-*/^ ") == std::string::npos ? text : fmt::format("({})", text);
}

}  // namespace

Quantity operator*(const Quantity& a, const Quantity& b) {
    const double value = a.value * b.value;
    if (a.text.empty() && b.text.empty()) return value;
    return {value, fmt::format("{} * {}", as_factor(a), as_factor(b))};
}

Quantity operator-(const Quantity& a) {
    if (a.text.empty()) return -a.value;
    return {-a.value, fmt::format("-{}", as_factor(a))};
}

}  // namespace steplab
