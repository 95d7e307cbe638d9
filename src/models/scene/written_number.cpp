#include "models/scene/written_number.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

namespace steplab {

namespace {

std::string written(const WrittenNumber& quantity) {
    return quantity.text.empty() ? number_text(quantity.value) : quantity.text;
}

/// In brackets where it is more than a name or a number.
std::string as_factor(const WrittenNumber& quantity) {
    const std::string text = written(quantity);
    return text.find_first_of("+-*/^ ") == std::string::npos ? text : fmt::format("({})", text);
}

}  // namespace

WrittenNumber operator*(const WrittenNumber& a, const WrittenNumber& b) {
    const double value = a.value * b.value;
    if (a.text.empty() && b.text.empty()) return value;
    return {value, fmt::format("{} * {}", as_factor(a), as_factor(b))};
}

WrittenNumber operator-(const WrittenNumber& a) {
    if (a.text.empty()) return -a.value;
    return {-a.value, fmt::format("-{}", as_factor(a))};
}

}  // namespace steplab
