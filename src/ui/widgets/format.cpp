#include "ui/widgets/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

/// "1.9e+06" -> "1.9e6", "2.1e-07" -> "2.1e-7".
std::string short_exponent(std::string text) {
    const auto e = text.find('e');
    if (e == std::string::npos) return text;
    auto digits = e + 1;
    if (text[digits] == '+') text.erase(digits, 1);
    if (text[digits] == '-') ++digits;
    while (digits + 1 < text.size() && text[digits] == '0') text.erase(digits, 1);
    return text;
}

std::string significant(double value, int digits) {
    if (std::isnan(value)) return "not a number";
    if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
    if (value == 0) return "0";
    const double size = std::abs(value);
    if (size < 1e-3 || size >= 1e5) return short_exponent(fmt::format("{:.{}e}", value, digits - 1));
    const int before_point = static_cast<int>(std::floor(std::log10(size))) + 1;
    return fmt::format("{:.{}f}", value, std::clamp(digits - before_point, 0, 6));
}

/// "2.000" -> "2.0", "1.500e-5" -> "1.5e-5".
std::string without_zeros(const std::string& text) {
    const auto point = text.find('.');
    if (point == std::string::npos) return text;
    const auto end = std::min(text.find('e'), text.size());
    auto keep = end;
    while (keep > point + 2 && text[keep - 1] == '0') --keep;
    return text.substr(0, keep) + text.substr(end);
}

}  // namespace

std::string number(double value, int digits) { return without_zeros(significant(value, digits)); }

std::string reading(double value) { return significant(value, 3); }

std::string with_unit(std::string text, std::string_view unit) {
    if (!unit.empty()) text.append(" ").append(unit);
    return text;
}

std::string scientific(double value) {
    if (value == 0) return "0";
    if (!std::isfinite(value)) return number(value);
    if (std::abs(value) >= 0.01 && std::abs(value) < 1000) {
        return std::abs(value) < 10 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value);
    }
    return short_exponent(fmt::format("{:.1e}", value));
}

std::string vector(Vec3 value) {
    const double largest = std::max({std::abs(value.x), std::abs(value.y), std::abs(value.z)});
    const auto part = [&](double v) {
        return std::abs(v) <= 1e-9 * largest ? std::string("0") : short_exponent(fmt::format("{:.2g}", v));
    };
    return fmt::format("({}, {}, {})", part(value.x), part(value.y), part(value.z));
}

std::string time_text(double time, double dt) {
    const int decimals = dt > 0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(dt))), 1, 7) : 3;
    return fmt::format("{:.{}f}", time, decimals);
}

std::string counted(double count, std::string_view one, std::string_view many) {
    return fmt::format("{:g} {}", count, count == 1 ? one : many);
}

std::optional<double> digits_right(double error, double scale) {
    if (!(error > 0) || !(scale > 0) || !std::isfinite(error) || !std::isfinite(scale)) return std::nullopt;
    return std::max(0.0, -std::log10(error / scale));
}

double rounded_for_slider(double value, double low, double high, bool logarithmic) {
    const double size = logarithmic ? std::abs(value) : high - low;
    if (size == 0) return value;
    // A slider has some hundred places: three digits of its range, or of the value itself, tell them apart.
    const double exponent = std::floor(std::log10(size)) - 2;
    const double unit = std::pow(10.0, std::abs(exponent));
    return exponent < 0 ? std::round(value * unit) / unit : std::round(value / unit) * unit;
}

}  // namespace steplab::ui
