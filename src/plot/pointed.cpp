#include "plot/pointed.hpp"

#include <cmath>

namespace steplab::plot {
namespace {

/// Index of the nearest of ascending x; none where the pointer is more than a pixel before the first or behind the
/// last.
std::optional<std::size_t> reached(std::span<const double> x, const Axis& across, float pixel) {
    if (x.empty() || pixel < across.pixel(x.front()) - 1 || pixel > across.pixel(x.back()) + 1) return std::nullopt;
    return nearest(x, across.value(pixel));
}

std::size_t nearest_in_pixels(const Curve& curve, const Axes& axes, Point pointer) {
    const auto distance = [&](std::size_t i) {
        return std::hypot(axes.across.pixel(curve.x[i]) - pointer.x, axes.up.pixel(curve.y[i]) - pointer.y);
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < curve.x.size(); ++i) {
        if (distance(i) < distance(best)) best = i;
    }
    return best;
}

}  // namespace

std::vector<PointedPoint> points_at(const Plot& plot, const Axes& axes, Point pointer) {
    std::vector<PointedPoint> points;
    for (const Curve& curve : plot.curves) {
        if (curve.x.empty()) continue;
        const auto index = curve.ascending ? reached(curve.x, axes.across, pointer.x)
                                           : std::optional(nearest_in_pixels(curve, axes, pointer));
        if (index && std::isfinite(curve.y[*index])) points.push_back({&curve, *index});
    }
    return points;
}

std::optional<std::size_t> place_at(const Band& band, const Axes& axes, Point pointer) {
    return reached(band.x, axes.across, pointer.x);
}

}  // namespace steplab::plot
