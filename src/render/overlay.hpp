#pragma once

#include "render/axes.hpp"
#include "render/colouring.hpp"
#include "render/occupancy.hpp"
#include "render/sketch.hpp"
#include "render/split.hpp"

#include <string>
#include <vector>

namespace steplab::render {

/// Texts and symbols over a picture of a scene. Each function adds to the sketch.

/// The upper left corner of a label whose text has this size: where it would be cut by the edge of the picture, it is
/// moved inside, a title among the numbers of its axis.
PixelPoint place_of(const AxisLabel& label, PixelPoint text, PictureSize picture);
/// Numbers and titles of the axes in a picture of this size, but those on particles, under the texts in `texts`, and of
/// axes that are too short.
void sketch_labels(Sketch& sketch, const Axes& axes, const Occupancy& taken, const PictureArea& texts,
                   PictureSize picture, const Palette& palette);
/// The small xyz cross at the lower left, and its mark that keeps labels away.
void mark_cross(Occupancy& taken, PictureSize size, double pixel_scale);
/// The part of the picture in which the cross is.
PictureArea cross_area(PictureSize size, double pixel_scale);
void sketch_cross(Sketch& sketch, const Projection& projection, const Palette& palette, double pixel_scale);
/// A number beside the colour scale.
struct LegendMark {
    double part = 0;  ///< of the scale's height at which it stands, from its foot
    std::string text;
};
std::vector<LegendMark> legend_marks(const ColourScale& scale);
/// The colour scale with title and numbers at the upper right, `lower` by some pixels where texts are above it.
void sketch_legend(Sketch& sketch, const ColourScale& scale, PictureSize size, const Palette& palette,
                   double pixel_scale, double lower = 0);

/// At the lower right, that only one of so many particles is drawn.
void sketch_share(Sketch& sketch, std::size_t one_of, PictureSize size, const Palette& palette, double pixel_scale);

}  // namespace steplab::render
