#include "core/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace steplab {

namespace {

template <class T>
std::string shortest(T value) {
    if (std::isnan(value)) return "nan";  // whatever its sign
    char buffer[32];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
    return std::string(buffer, result.ptr);
}

/// value = mantissa · 10^exponent, the mantissa rounded to its digits.
struct Scientific {
    std::string mantissa;
    int exponent;

    std::string text() const { return fmt::format("{}e{}", mantissa, exponent); }
};

/// Of a text with an exponent.
Scientific taken_apart(const std::string& text) {
    const std::size_t e = text.find('e');
    return {text.substr(0, e), std::atoi(text.c_str() + e + 1)};
}

Scientific scientific(double value, int digits) { return taken_apart(fmt::format("{:.{}e}", value, digits - 1)); }

/// "1e-07" -> "1e-7", "4.7e+11" -> "4.7e11"; other texts as they are.
std::string with_plain_exponent(std::string number) {
    const bool has_exponent = number.find('e') != std::string::npos;
    return has_exponent ? taken_apart(number).text() : number;
}

/// Cuts zeros at the end of the decimals of which at least `kept` stay: "2.000" -> "2.0" or "2".
void cut_zeros(std::string& number, std::size_t kept) {
    const std::size_t point = number.find('.');
    if (point == std::string::npos) return;
    number.erase(std::max(number.find_last_not_of('0'), point + kept) + 1);
    if (number.back() == '.') number.pop_back();
}

Scientific without_zeros(Scientific number, std::size_t kept) {
    cut_zeros(number.mantissa, kept);
    return number;
}

bool is_short_decimal(double value) {
    const double size = std::abs(value);
    return value == 0 || (size >= 9.995e-4 && size < 9999.5);
}

/// All digits before the point, `digits` significant ones after it.
std::string decimal(double value, int digits) {
    if (!std::isfinite(value)) return shortest(value);
    const double rounded = std::abs(value) >= std::pow(10, digits) ? std::round(value) : value;
    return fmt::format("{:.{}g}", rounded, std::abs(rounded) >= std::pow(10, digits) ? 4 : digits);
}

std::string raised(int exponent) {
    constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
    return text;
}

/// What the panels show of a number that has no digits.
std::optional<std::string> digitless(double value) {
    if (std::isnan(value)) return "not a number";
    if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
    if (value == 0) return "0";
    return std::nullopt;
}

bool needs_exponent(double value) { return std::abs(value) < 1e-3 || std::abs(value) >= 1e5; }

/// `digits` significant digits without an exponent.
std::string fixed(double value, int digits) {
    const int before_point = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    return fmt::format("{:.{}f}", value, std::clamp(digits - before_point, 0, 6));
}

}  // namespace

std::string number_text(double value) { return shortest(value); }
std::string number_text(float value) { return shortest(value); }
std::string exact_text(double value) { return with_plain_exponent(shortest(value)); }

std::optional<double> parse_number(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc{} || result.ptr != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string readable(double value, int digits) {
    if (auto text = digitless(value)) return *text;
    if (is_short_decimal(value)) return decimal(value, digits);
    const auto [mantissa, exponent] = without_zeros(scientific(value, digits), 0);
    return (mantissa == "1" ? "10" : mantissa + "·10") + raised(exponent);
}

std::string typed(double value, int digits) {
    if (!std::isfinite(value)) return shortest(value);
    if (is_short_decimal(value)) return decimal(value, digits);
    return without_zeros(scientific(value, digits), 0).text();
}

std::string significant(double value, int digits) { return with_plain_exponent(fmt::format("{:.{}g}", value, digits)); }

std::string setting_text(double value, int digits) {
    if (auto text = digitless(value)) return *text;
    if (needs_exponent(value)) return without_zeros(scientific(value, digits), 1).text();
    std::string text = fixed(value, digits);
    cut_zeros(text, 1);
    return text;
}

std::string reading_text(double value) {
    constexpr int digits = 3;
    if (auto text = digitless(value)) return *text;
    return needs_exponent(value) ? scientific(value, digits).text() : fixed(value, digits);
}

std::string rounded_text(double value) {
    if (auto text = digitless(value)) return *text;
    const double size = std::abs(value);
    if (size < 0.01 || size >= 1000) return scientific(value, 2).text();
    return size < 10 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value);
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

std::string short_number(double value) {
    if (auto text = digitless(value)) return *text;
    const bool has_long_integer_part = std::abs(value) >= 1000 && std::abs(value) < 1e7;
    return has_long_integer_part ? fmt::format("{:.0f}", value) : significant(value, 4);
}

}  // namespace steplab
