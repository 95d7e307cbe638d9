#include "lab/report/ticks.hpp"

#include "core/duration.hpp"
#include "core/number_text.hpp"
#include "core/ticks.hpp"

#include <cmath>

namespace steplab {

namespace {

constexpr int most_texts = 9;  // that fit next to each other

std::string text_of(double value, Quantity quantity) {
    if (quantity == Quantity::seconds) return duration_text(value);
    if (quantity == Quantity::count && value >= 1 && value < 1e7)
        return grouped(static_cast<unsigned long long>(std::llround(value)));
    return value == 1 ? "1" : readable(value);
}

}  // namespace

std::vector<Tick> decades(std::pair<double, double> range, Quantity quantity) {
    const std::vector<int> exponents = decades(range.first, range.second);
    const int every = (static_cast<int>(exponents.size()) - 1) / most_texts + 1;
    std::vector<Tick> ticks;
    for (const int exponent : exponents) {
        const double value = std::pow(10.0, exponent);
        ticks.push_back({value, exponent % every == 0 ? text_of(value, quantity) : ""});
    }
    return ticks;
}

}  // namespace steplab
