#pragma once

#include "lab/report/figure.hpp"

#include <string>
#include <utility>
#include <vector>

namespace steplab {

/// The name of a curve at its place in the figure, in pixels from the upper left corner: the left end of the text, half
/// way up.
struct CurveLabel {
    std::string text;
    int colour = 0;
    double x = 0, y = 0;
};

/// A place for the name of each coloured curve: beside one of its points, within the frame, where it covers no other
/// name and as few marks of coloured curves as can be.
std::vector<CurveLabel> curve_labels(const Figure& figure, std::pair<double, double> x_range,
                                     std::pair<double, double> y_range);

}  // namespace steplab
