#pragma once

#include "plot/plot.hpp"

#include <string>
#include <vector>

namespace steplab::plot {

/// The colours of a picture, as SVG has them: "#1b2430", or "var(--ink)" of the styles of a page.
struct Inks {
    std::string paper, text, dim, grid;
    std::string exact, quiet;         ///< of curves
    std::vector<std::string> curves;  ///< of curves 0, 1, 2 ..., from the first again after the last
};

/// The picture of a plot as a file of its own: SVG on white, 720 x 440 pixels, with title, axes, legend and caption.
/// The same plot gives the same bytes.
std::string svg(const Plot& plot);

/// The same as an element of a page, 600 x 400 pixels: without caption, and with the name of each curve next to it
/// instead of a legend; powers of ten are "10⁻⁷". A curve is <g class="curve" data-name="first word of its name"> with
/// its name as title. Empty if there is nothing to draw.
std::string svg_element(const Plot& plot, const Inks& inks);

}  // namespace steplab::plot
