#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace steplab {

/// Points of one line of a figure.
struct Curve {
    std::string name;  ///< in the legend
    std::vector<std::pair<double, double>> points;
    int colour = 0;       ///< index into the palette
    bool dashed = false;  ///< for a second curve of the same colour
    bool marks = true;    ///< a mark at each point
};

/// A diagram with logarithmic axes where wanted.
struct Figure {
    std::string x_label, y_label;
    bool log_x = true, log_y = true;
    std::optional<std::pair<double, double>> y_range = {};  ///< none: as the points need
    std::vector<Curve> curves;
};

/// Draws the figures by gnuplot: each as an SVG element to stand in a page. Throws Error (exit code 3) if gnuplot
/// cannot be run, naming its package.
std::vector<std::string> svg_figures(std::span<const Figure> figures);

}  // namespace steplab
