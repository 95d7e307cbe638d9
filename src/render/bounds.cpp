#include "render/bounds.hpp"

#include "core/ticks.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::render {
namespace {

// Approximate number of cells of the ground grid along the longest side of the scene.
constexpr double wanted_cells = 14;

Vec3 smaller(Vec3 a, Vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 larger(Vec3 a, Vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

double largest(Vec3 v) { return std::max({v.x, v.y, v.z}); }

}  // namespace

std::array<Vec3, 8> Bounds::corners() const {
    return {{{low.x, low.y, low.z},
             {high.x, low.y, low.z},
             {low.x, high.y, low.z},
             {high.x, high.y, low.z},
             {low.x, low.y, high.z},
             {high.x, low.y, high.z},
             {low.x, high.y, high.z},
             {high.x, high.y, high.z}}};
}

bool drawable(Vec3 point) {
    constexpr double farthest = 1e100;  // its square and cube do not overflow
    return std::abs(point.x) < farthest && std::abs(point.y) < farthest && std::abs(point.z) < farthest;
}

Bounds bounds_of(std::span<const Vec3> points) {
    const auto first = std::find_if(points.begin(), points.end(), drawable);
    if (first == points.end()) return {};
    Bounds bounds{*first, *first};
    for (const Vec3& point : points) {
        if (drawable(point)) bounds = {smaller(bounds.low, point), larger(bounds.high, point)};
    }
    return bounds;
}

Bounds joined(const Bounds& a, const Bounds& b) { return {smaller(a.low, b.low), larger(a.high, b.high)}; }

Bounds widened(const Bounds& bounds, double margin) {
    const Vec3 by{margin, margin, margin};
    return {bounds.low - by, bounds.high + by};
}

Bounds expected_bounds(const Shape& shape) {
    const Bounds rest = bounds_of(shape.rest);
    return shape.expected.empty() ? rest : joined(rest, bounds_of(shape.expected));
}

AxesBox axes_box(const Frame& frame) {
    const Shape& shape = *frame.shape;
    if (!shape.is_periodic() && !frame.cell && frame.magnified == 1)
        return axes_box(expected_bounds(shape), shape.spacing, bounds_of(frame.positions));
    std::vector<Vec3> seen(frame.positions.size());
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = frame.seen(i);
    return axes_box(expected_bounds(shape), shape.spacing, with_cell(bounds_of(seen), frame));
}

Bounds with_cell(const Bounds& bounds, const Frame& frame) {
    return frame.cell ? joined(bounds, bounds_of(frame.cell->corners())) : bounds;
}

AxesBox axes_box(const Bounds& expected, double spacing, const Bounds& now) {
    const Bounds usual = widened(expected, 0.75 * spacing);
    const Bounds whole = joined(usual, now);
    const double step = nice_ceil(largest(whole.size()) / wanted_cells);
    const auto low = [step](double usual_low, double seen) {
        return usual_low - std::ceil(std::max(usual_low - seen, 0.0) / step) * step;
    };
    const auto high = [step](double usual_high, double seen) {
        return usual_high + std::ceil(std::max(seen - usual_high, 0.0) / step) * step;
    };
    return {{{low(usual.low.x, now.low.x), low(usual.low.y, now.low.y), low(usual.low.z, now.low.z)},
             {high(usual.high.x, now.high.x), high(usual.high.y, now.high.y), high(usual.high.z, now.high.z)}},
            step};
}

}  // namespace steplab::render
