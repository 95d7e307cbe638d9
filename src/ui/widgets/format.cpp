#include "ui/widgets/format.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab::ui {

std::string with_unit(std::string text, std::string_view unit) {
    if (!unit.empty()) text.append(" ").append(unit);
    return text;
}

std::string vector(Vec3 value) {
    const double largest = std::max({std::abs(value.x), std::abs(value.y), std::abs(value.z)});
    const auto part = [&](double v) { return std::abs(v) <= 1e-9 * largest ? std::string("0") : typed(v); };
    return fmt::format("({}, {}, {})", part(value.x), part(value.y), part(value.z));
}

std::string time_text(double time, double dt) {
    if (!(std::abs(time) < 1e9)) return setting_text(time, 9);
    constexpr double usual = 3, most = 7;
    const bool known = dt > 0 && std::isfinite(dt);
    const double decimals = known ? std::clamp(2 - std::floor(std::log10(dt)), 1.0, most) : usual;
    return fmt::format("{:.{}f}", time, static_cast<int>(decimals));
}

std::string count_text(double count) {
    return std::abs(count) < 999'999.5 ? fmt::format("{:.0f}", count) : setting_text(count, 3);
}

std::string frequency_text(double often) { return often < 99.5 ? rounded_text(often) : count_text(often); }

std::string error_text(double error) {
    const double size = std::abs(error);
    if (!(size >= 0.01 && size < 9.95)) return rounded_text(error);
    return fmt::format("{:#.2g}", error);
}

std::string counted(double count, std::string_view one, std::string_view many) {
    return fmt::format("{:g} {}", count, count == 1 ? one : many);
}

std::optional<double> correct_digits(double error, double scale, Precision precision) {
    if (!(error >= 0) || !(scale > 0) || !std::isfinite(error) || !std::isfinite(scale)) return std::nullopt;
    // half a unit in the last place: 7.2 digits and 15.9, not rounded up
    const double most = precision == Precision::float_ ? 7.2 : 15.9;
    return std::clamp(-std::log10(error / scale), 0.0, most);
}

std::string digits_text(double digits) {
    if (digits < 1) return "wrong: not one correct digit";
    return fmt::format("{:.1f} correct digits so far", digits);
}

double rounded_for_slider(double value, double low, double high, bool logarithmic) {
    const double size = logarithmic ? std::abs(value) : high - low;
    // A slider has a few hundred positions: three digits distinguish them.
    const double exponent = std::floor(std::log10(size)) - 2;
    constexpr double largest = 300;  // powers of ten up to here are doubles, and so are their inverses
    if (!(std::abs(exponent) <= largest)) return value;
    const double unit = std::pow(10.0, std::abs(exponent));
    return exponent < 0 ? std::round(value * unit) / unit : std::round(value / unit) * unit;
}

}  // namespace steplab::ui
