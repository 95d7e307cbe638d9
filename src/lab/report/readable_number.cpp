#include "lab/report/readable_number.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace steplab {

namespace {

/// value = mantissa · 10^exponent, the mantissa rounded to its digits.
struct Scientific {
    std::string mantissa;
    int exponent;
};

Scientific scientific(double value, int digits) {
    const std::string text = fmt::format("{:.{}e}", value, digits - 1);
    const std::size_t e = text.find('e');
    std::string mantissa = text.substr(0, e);
    if (mantissa.find('.') != std::string::npos) mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.back() == '.') mantissa.pop_back();
    return {mantissa, std::atoi(text.c_str() + e + 1)};
}

bool is_short_decimal(double value) {
    const double size = std::abs(value);
    return value == 0 || !std::isfinite(value) || (size >= 9.995e-4 && size < 9999.5);
}

/// All digits before the decimal point; after it up to `digits` significant ones.
std::string decimal(double value, int digits) {
    const double rounded = std::abs(value) >= std::pow(10, digits) ? std::round(value) : value;
    return fmt::format("{:.{}g}", rounded, std::abs(rounded) >= std::pow(10, digits) ? 4 : digits);
}

std::string raised(int exponent) {
    constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
    return text;
}

}  // namespace

std::string readable(double value, int digits) {
    if (is_short_decimal(value)) return decimal(value, digits);
    const auto [mantissa, exponent] = scientific(value, digits);
    return (mantissa == "1" ? "10" : mantissa + "·10") + raised(exponent);
}

std::string typed(double value, int digits) {
    if (is_short_decimal(value)) return decimal(value, digits);
    const auto [mantissa, exponent] = scientific(value, digits);
    return fmt::format("{}e{}", mantissa, exponent);
}

std::string grouped(unsigned long long count) {
    const std::string digits = std::to_string(count);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += "\u202f";
        text += digits[i];
    }
    return text;
}

}  // namespace steplab
