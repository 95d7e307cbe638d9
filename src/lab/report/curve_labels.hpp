#pragma once

#include "lab/report/figure.hpp"

#include <string>
#include <utility>
#include <vector>

namespace steplab {

/// The name of a curve and its position in the figure, in pixels from the upper left corner: the middle of the left end
/// of the text.
struct CurveLabel {
    std::string text;
    int colour = 0;
    double x = 0, y = 0;
};

/// A position for the name of each coloured curve: next to one of its points, within the frame, where it covers no
/// other name and as few marks of coloured curves as possible.
std::vector<CurveLabel> curve_labels(const Figure& figure, std::pair<double, double> x_range,
                                     std::pair<double, double> y_range);

}  // namespace steplab
