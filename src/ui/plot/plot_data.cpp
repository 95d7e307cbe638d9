#include "core/number_text.hpp"
#include "core/ticks.hpp"
#include "ui/plot/plot.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

/// Smallest and largest value that can be drawn; low > high if there is none.
struct Extent {
    double low = INFINITY;
    double high = -INFINITY;

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

bool drawable(const Plot& plot, double y) { return std::isfinite(y) && (!plot.logarithmic || y > 0); }

Extent extent_across(const Plot& plot) {
    Extent extent;
    for (const Curve& curve : plot.curves) {
        if (curve.x.empty()) continue;
        extent.add(curve.x.front());
        extent.add(curve.x.back());
    }
    return extent;
}

Extent extent_up(const Plot& plot) {
    Extent extent;
    for (const Curve& curve : plot.curves) {
        for (const double y : curve.y) {
            if (drawable(plot, y)) extent.add(y);
        }
    }
    return extent;
}

}  // namespace

bool has_values(const Plot& plot) {
    const Extent extent = extent_up(plot);
    return extent.low <= extent.high;
}

PlotAxes plot_axes(const Plot& plot, const Area& frame, int most) {
    const Extent x = extent_across(plot);
    const Extent y = extent_up(plot);
    PlotAxes axes;
    axes.across = {0, 1, false, frame.x, frame.right()};
    if (std::isfinite(x.low) && std::isfinite(x.high)) {
        axes.across.low = x.low;
        axes.across.high = x.high > x.low ? x.high : x.low + std::max(1.0, 1e-6 * std::abs(x.low));
    }
    if (y.low <= y.high) {
        const Range range = plot.logarithmic ? decade_range(y.low, y.high) : nice_range(y.low, y.high, most);
        axes.up = {range.low, range.high, plot.logarithmic, frame.bottom(), frame.y};
    }
    return axes;
}

std::string plot_csv(const Plot& plot) {
    std::string text = "time";
    for (const Curve& curve : plot.curves) text.append(",").append(curve.name);
    text.append("\n");
    const std::size_t rows = plot.curves.empty() ? 0 : plot.curves.front().x.size();
    for (std::size_t i = 0; i < rows; ++i) {
        text.append(number_text(plot.curves.front().x[i]));
        for (const Curve& curve : plot.curves) {
            text.append(",");
            if (std::isfinite(curve.y[i])) text.append(number_text(curve.y[i]));
        }
        text.append("\n");
    }
    return text;
}

}  // namespace steplab::ui
