#pragma once

#include "render/axes.hpp"
#include "render/colouring.hpp"
#include "render/occupancy.hpp"
#include "render/sketch.hpp"

namespace steplab::render {

/// What is written and drawn flat over a picture of a scene. Each adds to the sketch.

/// Numbers and titles of the axes; those that particles are drawn under fade.
void sketch_labels(Sketch& sketch, const Axes& axes, const Occupancy& taken, const Palette& palette);
/// The small cross of x, y and z at the lower left; where it is, no labels should be.
void mark_cross(Occupancy& taken, PictureSize size, double pixel_scale);
void sketch_cross(Sketch& sketch, const Projection& projection, const Palette& palette, double pixel_scale);
/// The colour scale with its title and numbers at the upper right.
void sketch_legend(Sketch& sketch, const ColourScale& scale, PictureSize size, const Palette& palette,
                   double pixel_scale);

}  // namespace steplab::render
