#include "core/ticks.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace steplab {

namespace {

constexpr double slack = 1e-9;
// Of powers of ten in double, subnormal ones included.
constexpr int smallest_exponent = -323;
constexpr int largest_exponent = 308;

/// digit * 10^exponent, rounded once where the power of ten is exact.
double scaled(double digit, int exponent) {
    const bool divides = exponent < 0 && exponent >= -largest_exponent;
    return divides ? digit / std::pow(10.0, -exponent) : digit * std::pow(10.0, exponent);
}

int exponent_of(double value) { return static_cast<int>(std::floor(std::log10(value))); }

/// Never of width 0 and never beyond the largest double.
Range range_around(double value) {
    const double half = value == 0 ? 1 : std::max(0.5 * std::abs(value), std::numeric_limits<double>::min());
    const double largest = std::numeric_limits<double>::max();
    return {std::max(value - half, -largest), std::min(value + half, largest)};
}

/// Subnormal numbers are farther apart than `slack`.
bool is_usable(double value) { return value > 0 && std::isnormal(value); }

}  // namespace

double nice_ceil(double value, std::span<const double> digits) {
    if (!is_usable(value)) return value;
    const int exponent = exponent_of(value);
    for (const double digit : digits) {
        const double nice = scaled(digit, exponent);
        if (nice >= value * (1 - slack)) return nice;
    }
    return scaled(1, exponent + 1);
}

double nice_floor(double value) {
    if (!is_usable(value)) return value;
    const int exponent = exponent_of(value);
    for (const double nice : {scaled(1, exponent + 1), scaled(5, exponent), scaled(2, exponent)}) {
        if (nice * (1 - slack) <= value) return nice;
    }
    return scaled(1, exponent);
}

double nice_above(double value) { return nice_ceil(value * (1 + 2 * slack)); }

double nice_below(double value) { return nice_floor(value * (1 - 2 * slack)); }

double nice_step(double low, double high, int intervals) {
    const double parts = std::max(intervals, 1);
    const double length = high - low;
    return nice_ceil(std::isfinite(length) ? length / parts : high / parts - low / parts);
}

std::vector<double> linear_ticks(double low, double high, double step) {
    constexpr double most = 1000;
    // Multiples up to this are several spacings of doubles apart.
    constexpr double largest_multiple = 1e15;
    std::vector<double> ticks;
    if (!is_usable(step)) return ticks;
    const double first = std::ceil(low / step - slack);
    const double last = std::floor(high / step + slack);
    const bool countable = std::abs(first) < largest_multiple && std::abs(last) < largest_multiple;
    if (!countable || last - first >= most) return ticks;
    for (double k = first; k <= last; ++k) ticks.push_back(k == 0 ? 0 : k * step);
    return ticks;
}

std::vector<int> decades(double low, double high) {
    std::vector<int> exponents;
    if (!(low > 0 && low <= high) || std::isinf(high)) return exponents;
    const int last = static_cast<int>(std::floor(std::log10(high) + slack));
    for (int exponent = static_cast<int>(std::ceil(std::log10(low) - slack)); exponent <= last; ++exponent)
        exponents.push_back(exponent);
    return exponents;
}

Range nice_range(double low, double high, int intervals) {
    if (!std::isfinite(low) || !std::isfinite(high)) return {};
    if (!(high > low)) return range_around(low);
    const int parts = std::max(intervals, 2);  // any range around 0 has two
    for (double step = nice_step(low, high, parts); is_usable(step); step = nice_above(step)) {
        const Range range{std::floor(low / step + slack) * step, std::ceil(high / step - slack) * step};
        if (!std::isfinite(range.low) || !std::isfinite(range.high)) break;
        const bool holds = range.low <= low + slack * step && range.high >= high - slack * step;
        if (holds && range.high - range.low <= (parts + slack) * step) return range;
    }
    return {low, high};
}

Range decade_range(double low, double high) {
    if (!(low > 0 && high > 0) || std::isinf(low) || std::isinf(high)) return {};
    const int bottom = std::clamp(exponent_of(low), smallest_exponent, largest_exponent - 1);
    const int top = std::clamp(static_cast<int>(std::ceil(std::log10(high))), bottom + 1, largest_exponent);
    return {std::min(std::pow(10.0, bottom), low), std::max(std::pow(10.0, top), high)};
}

std::string tick_text(double value, double step, double largest) {
    if (!is_usable(step) || !std::isfinite(value)) return typed(value, 6);
    if (std::abs(value) < step * slack) return "0";
    const double magnitude = std::floor(std::log10(step) + slack);
    const int decimals = magnitude < 0 ? static_cast<int>(-magnitude) : 0;
    if (decimals <= 4 && largest < 99999.5) return fmt::format("{:.{}f}", value, decimals);
    const double power = std::floor(std::log10(std::abs(value)) + slack);
    const int digits = static_cast<int>(std::clamp(power - magnitude, 0.0, 17.0));
    return fmt::format("{:.{}f}e{:.0f}", value / std::pow(10.0, power), digits, power);
}

double part_between(double low, double high, double value) {
    const double length = high - low;
    return std::isfinite(length) ? (value - low) / length : (value / 2 - low / 2) / (high / 2 - low / 2);
}

}  // namespace steplab
