#pragma once

#include "core/frame.hpp"
#include "core/vec3.hpp"

#include <array>
#include <span>

namespace steplab::render {

/// An axis-aligned box.
struct Bounds {
    Vec3 low;
    Vec3 high;

    Vec3 centre() const { return 0.5 * (low + high); }
    Vec3 size() const { return high - low; }
    std::array<Vec3, 8> corners() const;
    friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// False for positions that cannot be drawn: not finite, or so large that their squares and cubes overflow.
bool drawable(Vec3 point);

/// The smallest box around all points that can be drawn; the origin if there are none.
Bounds bounds_of(std::span<const Vec3> points);
Bounds joined(const Bounds& a, const Bounds& b);
/// Larger by `margin` on every side.
Bounds widened(const Bounds& bounds, double margin);

/// The box around a scene at rest and the places that it is expected to reach.
Bounds expected_bounds(const Shape& shape);

/// The box whose edges carry the axes: slightly larger than expected_bounds(). Where the frame leaves it, it grows by
/// whole steps, so that it rarely changes while the scene moves.
struct AxesBox {
    Bounds bounds;
    double step = 1;  ///< of the ground grid, a nice number (core/ticks.hpp)
    friend bool operator==(const AxesBox&, const AxesBox&) = default;
};
AxesBox axes_box(const Frame& frame);
/// With the corners of the frame's cell, if it has one.
Bounds with_cell(const Bounds& bounds, const Frame& frame);
/// The same for a scene with these expected_bounds() and spacing of neighbours, whose particles are in the box `now`.
AxesBox axes_box(const Bounds& expected, double spacing, const Bounds& now);

}  // namespace steplab::render
