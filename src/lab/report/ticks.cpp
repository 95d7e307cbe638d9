#include "lab/report/ticks.hpp"

#include "core/duration.hpp"
#include "core/number_text.hpp"

#include <cmath>

namespace steplab {

namespace {

std::string text_of(double value, Quantity quantity) {
    if (quantity == Quantity::seconds) return duration_text(value);
    if (quantity == Quantity::count && value >= 1 && value < 1e7)
        return grouped(static_cast<unsigned long long>(std::llround(value)));
    return value == 1 ? "1" : readable(value);
}

}  // namespace

std::vector<Tick> decades(std::pair<double, double> range, Quantity quantity) {
    const int first = static_cast<int>(std::ceil(std::log10(range.first) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(range.second) + 1e-9));
    const int every = (last - first) / 9 + 1;
    std::vector<Tick> ticks;
    for (int decade = first; decade <= last; ++decade) {
        const double value = std::pow(10.0, decade);
        ticks.push_back({value, decade % every == 0 ? text_of(value, quantity) : ""});
    }
    return ticks;
}

}  // namespace steplab
