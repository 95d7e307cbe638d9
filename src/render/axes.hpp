#pragma once

#include "core/shape.hpp"
#include "render/bounds.hpp"
#include "render/camera.hpp"

#include <optional>
#include <string>
#include <vector>

namespace steplab::render {

/// A line of the axes in space and its opacity, 0 .. 1.
struct AxisLine {
    Vec3 start;
    Vec3 end;
    double strength = 1;
};

/// A text of the axes: the place of its centre in the picture and its opacity, 0 .. 1.
struct AxisLabel {
    std::string text;
    PixelPoint centre;
    double strength = 1;
    /// Of a title: a place nearer to its axis, between two numbers, if that is in the picture.
    std::optional<PixelPoint> nearer = {};
};

/// Axes along three outer edges of a box as it is seen, two of them of its floor, with ticks and texts outside.
struct Axes {
    std::vector<AxisLine> lines;
    std::vector<AxisLabel> labels;
};

/// An axis that points towards the camera fades. Ticks are as close as their numbers allow. Distances in the picture,
/// such as that of a number from its axis, are proportional to `pixel_scale`.
Axes axes_of(const AxesBox& box, const Projection& projection, double pixel_scale);

/// Adds the edges of the periodic box. Along an axis on which it is open they are as long as what is drawn, `within`,
/// and only the lower end has edges across, fainter.
void add_box_edges(Axes& axes, const Shape& shape, const Bounds& within);
/// The twelve edges of a cell.
void add_cell_edges(Axes& axes, const Cell& cell);

}  // namespace steplab::render
