#include "plot/scale.hpp"

#include "core/duration.hpp"
#include "core/number_text.hpp"
#include "core/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace steplab::plot {
namespace {

/// The value on a linear axis that takes the place of this one.
double mapped(const Axis& axis, double value) {
    switch (axis.scale) {
        case Scale::logarithmic:
            return std::log(value);
        case Scale::symmetric_logarithmic:
            return std::asinh(value / axis.threshold);
        default:
            return value;
    }
}

double unmapped(const Axis& axis, double place) {
    switch (axis.scale) {
        case Scale::logarithmic:
            return std::exp(place);
        case Scale::symmetric_logarithmic:
            return std::sinh(place) * axis.threshold;
        default:
            return place;
    }
}

/// Ends of an axis that has no nice numbers: less than a few spacings of doubles long, or subnormal.
std::vector<Tick> ends_of(const Axis& axis) {
    if (!(axis.low < axis.high) || !std::isfinite(axis.low) || !std::isfinite(axis.high)) return {};
    return {{axis.low, typed(axis.low, 6)}, {axis.high, typed(axis.high, 6)}};
}

std::vector<Tick> linear_ticks_of(const Axis& axis, int most) {
    constexpr std::size_t longest = 9;
    const double step = nice_step(axis.low, axis.high, most);
    const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
    std::vector<Tick> found;
    for (const double value : linear_ticks(axis.low, axis.high, step)) {
        // There is no room for all the digits of values that differ by a tiny part.
        std::string label = tick_text(value, step, largest);
        found.push_back({value, label.size() <= longest ? std::move(label) : typed(value, 6)});
    }
    return found.empty() ? ends_of(axis) : found;
}

std::string text_of_power(int exponent, Numbers numbers) {
    const double value = std::pow(10.0, exponent);
    if (numbers == Numbers::seconds) return duration_text(value);
    if (numbers == Numbers::counts && exponent >= 0 && exponent < 7)
        return grouped(static_cast<unsigned long long>(std::llround(value)));
    if (numbers != Numbers::typed) return exponent == 0 ? "1" : readable(value);
    const bool plain = exponent >= -2 && exponent <= 3;
    return plain ? number_text(value) : fmt::format("1e{}", exponent);
}

Tick power_of_ten(int exponent, Numbers numbers, double sign = 1) {
    return {sign * std::pow(10.0, exponent),
            fmt::format("{}{}", sign < 0 ? "-" : "", text_of_power(exponent, numbers))};
}

/// Of so many ticks every how many are shown, if there are to be at most so many intervals.
std::size_t every_of(std::size_t ticks, int most) {
    const auto intervals = static_cast<std::size_t>(std::max(most, 1));
    return std::max<std::size_t>(1, (ticks + intervals - 2) / intervals);
}

std::vector<Tick> logarithmic_ticks_of(const Axis& axis, int most) {
    const std::vector<int> exponents = decades(axis.low, axis.high);
    std::vector<Tick> found;
    for (std::size_t i = 0; i < exponents.size(); i += every_of(exponents.size(), most))
        found.push_back(power_of_ten(exponents[i], axis.numbers));
    return found;
}

/// The same powers on both sides, so that the eye sees what is as far above 0 as below.
std::vector<Tick> symmetric_ticks_of(const Axis& axis, int most) {
    if (!(axis.low < axis.high)) return {};
    const std::vector<int> exponents = decades(axis.threshold, std::max(-axis.low, axis.high));
    const bool both = axis.low < 0 && axis.high > 0;
    const std::size_t every = every_of(exponents.size(), both ? std::max(1, most / 2) : most);
    std::vector<Tick> below, above;
    for (std::size_t i = every - 1; i < exponents.size(); i += every) {
        below.push_back(power_of_ten(exponents[i], axis.numbers, -1));
        above.push_back(power_of_ten(exponents[i], axis.numbers));
    }
    std::vector<Tick> found(below.rbegin(), below.rend());
    found.push_back({0, "0"});
    found.insert(found.end(), above.begin(), above.end());
    std::erase_if(found, [&](const Tick& tick) { return tick.value < axis.low || tick.value > axis.high; });
    return found;
}

}  // namespace

bool Axis::can_show(double value) const { return std::isfinite(value) && (scale != Scale::logarithmic || value > 0); }

float Axis::pixel(double value) const {
    const double part = part_between(mapped(*this, low), mapped(*this, high), mapped(*this, value));
    // A pixel far outside, or none, would overflow what is drawn.
    const double near_by = part > -1 ? std::min(part, 2.0) : -1;
    return from + static_cast<float>(near_by) * (to - from);
}

double Axis::value(float pixel) const {
    const double part = to == from ? 0 : static_cast<double>((pixel - from) / (to - from));
    return unmapped(*this, std::lerp(mapped(*this, low), mapped(*this, high), part));
}

std::vector<Tick> ticks(const Axis& axis, int most) {
    switch (axis.scale) {
        case Scale::logarithmic:
            return logarithmic_ticks_of(axis, most);
        case Scale::symmetric_logarithmic:
            return symmetric_ticks_of(axis, most);
        default:
            return linear_ticks_of(axis, most);
    }
}

}  // namespace steplab::plot
