#pragma once

#include "core/frame.hpp"
#include "core/vec3.hpp"

#include <array>
#include <span>

namespace steplab::render {

/// A box along the axes of space.
struct Bounds {
    Vec3 low;
    Vec3 high;

    Vec3 centre() const { return 0.5 * (low + high); }
    Vec3 size() const { return high - low; }
    std::array<Vec3, 8> corners() const;
    friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// False for places that cannot be told in the arithmetic of the drawing: not finite, or beyond all measure.
bool drawable(Vec3 point);

/// The smallest box that holds all points that can be drawn; the origin alone if there are none.
Bounds bounds_of(std::span<const Vec3> points);
Bounds joined(const Bounds& a, const Bounds& b);
/// Larger by `margin` on every side.
Bounds widened(const Bounds& bounds, double margin);

/// The box of a scene at rest and of the places it is expected to reach.
Bounds expected_bounds(const Shape& shape);

/// The box whose edges carry the axes: a little more than expected_bounds(). Where the frame has left it, it is larger
/// by whole steps, so that it mostly stands still while the scene moves.
struct AxesBox {
    Bounds bounds;
    double step = 1;  ///< of the ground grid: 1, 2 or 5 times a power of ten
};
AxesBox axes_box(const Frame& frame);
/// The same of a scene with these expected_bounds() and distance of neighbours whose particles are in the box `now`.
AxesBox axes_box(const Bounds& expected, double spacing, const Bounds& now);

}  // namespace steplab::render
