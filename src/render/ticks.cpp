#include "render/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab::render {
namespace {

// Quotients of round numbers come out a few units in the last place off a whole number.
constexpr double slack = 1e-9;

}  // namespace

double round_number_from(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= value * (1 - slack)) return factor * power;
    }
    return 10 * power;
}

std::vector<double> ticks(double low, double high, double step) {
    constexpr double most = 1000;
    const double first = std::ceil(low / step - slack);
    const double last = std::floor(high / step + slack);
    std::vector<double> values;
    // So many, or numbers whose neighbours are farther apart than a step, are of no use to anybody.
    if (!(last - first < most) || first + 1 == first || last + 1 == last) return values;
    for (double k = first; k <= last; ++k) values.push_back(k * step);
    return values;
}

std::string tick_text(double value, double step, double largest) {
    if (std::abs(value) < step * slack) return "0";
    const double magnitude = std::floor(std::log10(step) + slack);
    const int decimals = magnitude < 0 ? static_cast<int>(-magnitude) : 0;
    if (decimals <= 4 && largest < 99999.5) return fmt::format("{:.{}f}", value, decimals);
    const double power = std::floor(std::log10(std::abs(value)) + slack);
    const int digits = static_cast<int>(std::max(power - magnitude, 0.0));
    return fmt::format("{:.{}f}e{:.0f}", value / std::pow(10.0, power), digits, power);
}

}  // namespace steplab::render
