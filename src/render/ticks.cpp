#include "render/ticks.hpp"

#include <fmt/format.h>

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
    const double first = std::ceil(low / step - slack);
    const double last = std::floor(high / step + slack);
    std::vector<double> values;
    for (double k = first; k <= last; ++k) values.push_back(k * step);
    return values;
}

std::string tick_text(double value, double step) {
    if (std::abs(value) < step * slack) return "0";
    const double magnitude = std::floor(std::log10(step) + slack);
    if (magnitude < -4 || std::abs(value) >= 1e6) return fmt::format("{:.4g}", value);
    return fmt::format("{:.{}f}", value, magnitude < 0 ? static_cast<int>(-magnitude) : 0);
}

}  // namespace steplab::render
