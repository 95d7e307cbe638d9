#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace steplab {

/// What the numbers beside an axis are: that decides how they are written.
enum class Quantity {
    number,   ///< 0, 5, 10; 10⁻⁶ on a logarithmic axis
    seconds,  ///< 10 µs, 1 ms
    count,    ///< 1000, 10 000
};

struct Axis {
    std::string label;
    Quantity quantity = Quantity::number;
    bool logarithmic = true;
    std::optional<std::pair<double, double>> range = {};  ///< none: as the points need
};

/// One whose numbers stand at equal distances.
inline Axis linear_axis(std::string label, std::optional<std::pair<double, double>> range = {}) {
    return {.label = std::move(label), .logarithmic = false, .range = range};
}

/// Points of one line of a figure.
struct Curve {
    std::string name;  ///< written beside the line if it has a colour, shown on pointing at it in any case
    std::vector<std::pair<double, double>> points;
    std::optional<int> colour = {};  ///< number in the page's palette; none: a thin grey line behind the others
    bool dashed = false;
    bool marks = true;  ///< a dot at each point
};

struct Figure {
    Axis x, y;
    std::vector<Curve> curves;
};

/// The size of all figures, and of the frame the curves stand in, in pixels from the upper left corner.
struct FigureArea {
    static constexpr double width = 600, height = 400;
    static constexpr double left = 78, right = 588, top = 12, bottom = 350;
};

/// The smallest and largest value that curves have on an axis (`of_x`: the horizontal one), logarithmic axes widened to
/// be a little larger; what cannot stand on it is left out. None if nothing can.
std::optional<std::pair<double, double>> range_of(std::span<const Curve> curves, bool of_x, bool logarithmic);

/// Draws the figures by gnuplot, each as an SVG element to stand in a page that has the styles of lab/report/page.hpp:
/// empty for a figure without a point. Throws FileError (exit code 3) if gnuplot cannot be run, naming its package;
/// throws Interrupted.
std::vector<std::string> svg_figures(std::span<const Figure> figures);

}  // namespace steplab
