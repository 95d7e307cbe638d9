#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace steplab {

/// The kind of numbers on an axis, which determines their format.
enum class Quantity {
    number,   ///< 0, 5, 10; 10⁻⁶ on a logarithmic axis
    seconds,  ///< 10 µs, 1 ms
    count,    ///< 1000, 10 000
};

struct Axis {
    std::string label;
    Quantity quantity = Quantity::number;
    bool logarithmic = true;
    std::optional<std::pair<double, double>> range = {};  ///< nullopt: determined by the points
};

/// A linear axis.
inline Axis linear_axis(std::string label, std::optional<std::pair<double, double>> range = {}) {
    return {.label = std::move(label), .logarithmic = false, .range = range};
}

/// Points of one line of a figure.
struct Curve {
    std::string name;  ///< written next to the line if it has a colour; always shown as a tooltip
    std::vector<std::pair<double, double>> points;
    std::optional<int> colour = {};  ///< number in the page's palette; nullopt: a thin grey line behind the others
    bool dashed = false;
    bool marks = true;  ///< a dot at each point
};

struct Figure {
    Axis x, y;
    std::vector<Curve> curves;
};

/// The size of all figures and of the frame of the curves, in pixels from the upper left corner.
struct FigureArea {
    static constexpr double width = 600, height = 400;
    static constexpr double left = 78, right = 588, top = 12, bottom = 350;
};

/// The smallest and largest value of curves on an axis (`of_x`: the horizontal one), widened a little on logarithmic
/// axes. Values that cannot be drawn on it are ignored; nullopt if there are no others.
std::optional<std::pair<double, double>> range_of(std::span<const Curve> curves, bool of_x, bool logarithmic);

/// Draws the figures with gnuplot, each as an SVG element for a page with the styles of lab/report/page.hpp: empty for
/// a figure without a point. Throws FileError (exit code 3) if gnuplot cannot be run, naming its package; throws
/// Interrupted.
std::vector<std::string> svg_figures(std::span<const Figure> figures);

}  // namespace steplab
