#include "ui/plot/axis.hpp"

#include "core/number_text.hpp"
#include "core/ticks.hpp"
#include "ui/widgets/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace steplab::ui {
namespace {

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

/// Every power of ten, or every second, third ... so that they divide the axis into at most `most` intervals.
std::vector<Tick> logarithmic_ticks_of(const Axis& axis, int most) {
    const std::vector<int> exponents = decades(axis.low, axis.high);
    const auto intervals = static_cast<std::size_t>(std::max(most, 1));
    const std::size_t every = std::max<std::size_t>(1, (exponents.size() + intervals - 2) / intervals);
    std::vector<Tick> found;
    for (std::size_t i = 0; i < exponents.size(); i += every) {
        const bool plain = exponents[i] >= -2 && exponents[i] <= 3;
        const double value = std::pow(10.0, exponents[i]);
        found.push_back({value, plain ? number_text(value) : fmt::format("1e{}", exponents[i])});
    }
    return found;
}

bool can_show(double x, double y, const Axis& up) {
    return std::isfinite(x) && std::isfinite(y) && (!up.logarithmic || y > 0);
}

/// The points of one column of pixels, in their order.
struct Column {
    PlotPoint first, lowest, highest, last;
    std::size_t count = 0;

    void add(PlotPoint point) {
        if (count++ == 0) first = lowest = highest = point;
        if (point.y > lowest.y) lowest = point;
        if (point.y < highest.y) highest = point;
        last = point;
    }
    void append_to(std::vector<PlotPoint>& points) {
        if (count > 0) points.push_back(first);
        if (count > 2) {
            const bool low_first = lowest.x < highest.x;
            points.push_back(low_first ? lowest : highest);
            points.push_back(low_first ? highest : lowest);
        }
        if (count > 1) points.push_back(last);
        count = 0;
    }
};

}  // namespace

float Axis::pixel(double value) const {
    const double part =
        logarithmic ? part_between(std::log(low), std::log(high), std::log(value)) : part_between(low, high, value);
    // A pixel far outside, or none, would overflow what is drawn.
    const double near_by = part > -1 ? std::min(part, 2.0) : -1;
    return from + static_cast<float>(near_by) * (to - from);
}

double Axis::value(float pixel) const {
    const double part = to == from ? 0 : static_cast<double>((pixel - from) / (to - from));
    return logarithmic ? std::exp(std::lerp(std::log(low), std::log(high), part)) : std::lerp(low, high, part);
}

std::vector<Tick> ticks(const Axis& axis, int most) {
    return axis.logarithmic ? logarithmic_ticks_of(axis, most) : linear_ticks_of(axis, most);
}

std::vector<PlotPoint> decimated(std::span<const double> x, std::span<const double> y, const Axis& across,
                                 const Axis& up) {
    std::vector<PlotPoint> points;
    Column column;
    float pixel = 0;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
        if (!can_show(x[i], y[i], up)) continue;
        const PlotPoint point{across.pixel(x[i]), up.pixel(y[i])};
        if (column.count > 0 && std::floor(point.x) != pixel) column.append_to(points);
        pixel = std::floor(point.x);
        column.add(point);
    }
    column.append_to(points);
    return points;
}

std::size_t nearest(std::span<const double> x, double value) {
    const auto above = std::lower_bound(x.begin(), x.end(), value);
    if (above == x.begin()) return 0;
    if (above == x.end()) return x.size() - 1;
    const auto below = std::prev(above);
    return static_cast<std::size_t>((value - *below <= *above - value ? below : above) - x.begin());
}

}  // namespace steplab::ui
