#pragma once

#include "plot/plot.hpp"

#include <vector>

namespace steplab::plot {

/// A point of a curve that a pointer is told of.
struct PointedPoint {
    const Curve* curve;
    std::size_t index = 0;
};

/// What lies at a pointer within the frame: of each curve the point over or under it or, where x does not ascend, the
/// nearest one in pixels. Curves that do not reach to there, or have a gap, have none.
std::vector<PointedPoint> points_at(const Plot& plot, const Axes& axes, Point pointer);

/// The same of a band: its place over or under the pointer.
std::optional<std::size_t> place_at(const Band& band, const Axes& axes, Point pointer);

}  // namespace steplab::plot
