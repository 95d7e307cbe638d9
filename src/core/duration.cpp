#include "core/duration.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace steplab {

namespace {

struct Unit {
    const char* name;
    double seconds;
};
constexpr std::array units{Unit{"ns", 1e-9}, Unit{"µs", 1e-6}, Unit{"ms", 1e-3}, Unit{"s", 1}};

/// To three digits without an exponent: 0.1234 -> "0.123", 999.6 -> "1000".
std::string three_digits(double value) {
    const double rounded = value < 100 ? value : std::round(value);
    return fmt::format("{:.{}g}", rounded, rounded < 1000 ? 3 : 4);
}

}  // namespace

std::string duration_text(double seconds) {
    if (!(seconds < 100 * 3600.0)) return "days";
    if (seconds <= 0) return "0 s";
    const auto whole = static_cast<long>(std::lround(seconds));
    if (whole >= 3600) return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
    if (whole >= 60) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    std::size_t unit = 0;
    while (unit + 1 < units.size() && seconds >= 0.9995 * units[unit + 1].seconds) ++unit;
    return three_digits(seconds / units[unit].seconds) + " " + units[unit].name;
}

std::string bytes_text(double bytes) {
    constexpr std::array names{"bytes", "kB", "MB", "GB", "TB", "PB"};
    std::size_t unit = 0;
    double value = bytes;
    for (; unit + 1 < names.size() && value >= 999.5; ++unit) value /= 1000;
    return value < 1000 ? three_digits(value) + " " + names[unit] : typed(bytes, 3) + " bytes";
}

}  // namespace steplab
