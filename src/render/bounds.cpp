#include "render/bounds.hpp"

#include "render/ticks.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::render {
namespace {

// Cells of the ground grid along the longer side of the scene, about.
constexpr double wanted_cells = 10;

Vec3 smaller(Vec3 a, Vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 larger(Vec3 a, Vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

Bounds on_grid(const Bounds& bounds, double step) {
    const auto down = [step](double value) { return std::floor(value / step) * step; };
    const auto up = [step](double value) { return std::ceil(value / step) * step; };
    return {{down(bounds.low.x), down(bounds.low.y), down(bounds.low.z)},
            {up(bounds.high.x), up(bounds.high.y), up(bounds.high.z)}};
}

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

Bounds bounds_of(std::span<const Vec3> points) {
    Bounds bounds{points.front(), points.front()};
    for (const Vec3& point : points) bounds = {smaller(bounds.low, point), larger(bounds.high, point)};
    return bounds;
}

Bounds joined(const Bounds& a, const Bounds& b) { return {smaller(a.low, b.low), larger(a.high, b.high)}; }

Bounds widened(const Bounds& bounds, double margin) {
    const Vec3 by{margin, margin, margin};
    return {bounds.low - by, bounds.high + by};
}

AxesBox axes_box(const Frame& frame) {
    const Shape& shape = *frame.shape;
    const double room = std::max(shape.extent_hint, 0.5 * shape.spacing);
    const Bounds seen = joined(widened(bounds_of(shape.rest), room), bounds_of(frame.positions));
    const Vec3 size = seen.size();
    const double step = round_number_from(std::max({size.x, size.y, size.z}) / wanted_cells);
    return {on_grid(seen, step), step};
}

}  // namespace steplab::render
