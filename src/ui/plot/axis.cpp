#include "ui/plot/axis.hpp"

#include "ui/widgets/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

/// The smallest of 1, 2, 5 times a power of ten that is not below `least`.
double round_step(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1 - 1e-9)) return factor * power;
    }
    return 10 * power;
}

std::string tick_label(double value, double step) {
    const double size = std::max(std::abs(value), step);
    if (size >= 1e5 || size < 1e-3) return fmt::format("{:.3g}", value);
    const int decimals = std::clamp(-static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 6);
    return fmt::format("{:.{}f}", value, decimals);
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
    const double part = logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return from + static_cast<float>(part) * (to - from);
}

double Axis::value(float pixel) const {
    const double part = static_cast<double>((pixel - from) / (to - from));
    return logarithmic ? low * std::pow(high / low, part) : low + part * (high - low);
}

std::vector<Tick> linear_ticks(double low, double high, int most) {
    std::vector<Tick> found;
    if (!(high > low) || most < 1) return found;
    const double step = round_step((high - low) / most);
    const double slack = 1e-9 * step;
    for (double k = std::ceil((low - slack) / step); k * step <= high + slack; ++k) {
        const double value = k == 0 ? 0 : k * step;
        found.push_back({value, tick_label(value, step)});
    }
    return found;
}

std::vector<Tick> logarithmic_ticks(double low, double high, int most) {
    std::vector<Tick> found;
    if (!(high > low) || !(low > 0) || most < 1) return found;
    const int first = static_cast<int>(std::ceil(std::log10(low) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
    const int every = std::max(1, (last - first + most - 1) / most);
    for (int exponent = first; exponent <= last; exponent += every) {
        const bool plain = exponent >= -2 && exponent <= 3;
        const double value = std::pow(10.0, exponent);
        found.push_back({value, plain ? fmt::format("{:g}", value) : fmt::format("1e{}", exponent)});
    }
    return found;
}

std::vector<Tick> ticks(const Axis& axis, int most) {
    return axis.logarithmic ? logarithmic_ticks(axis.low, axis.high, most) : linear_ticks(axis.low, axis.high, most);
}

Range round_range(double low, double high, int most) {
    if (!(high > low)) {
        const double half = low == 0 ? 1 : 0.5 * std::abs(low);
        return {low - half, low + half};
    }
    for (double step = round_step((high - low) / most);; step = round_step(1.5 * step)) {
        const Range range{std::floor(low / step + 1e-9) * step, std::ceil(high / step - 1e-9) * step};
        if (range.high - range.low <= (most + 1e-9) * step) return range;
    }
}

Range round_logarithmic_range(double low, double high) {
    const double bottom = std::floor(std::log10(low));
    const double top = std::max(std::ceil(std::log10(high)), bottom + 1);
    return {std::pow(10.0, bottom), std::pow(10.0, top)};
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
