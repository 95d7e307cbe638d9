#pragma once

#include "ui/context.hpp"
#include "ui/plot/axis.hpp"

#include <string>
#include <vector>

namespace steplab::ui {

/// A curve of a plot: y over ascending x.
struct Curve {
    std::string name = {};  ///< in the legend and in the header of the CSV file
    ImU32 ink = colour::accent;
    bool dashed = false;
    std::vector<double> x = {};
    std::vector<double> y = {};  ///< values that are not finite are gaps
};

/// The content of a plot. draw_plot() draws it, plot_csv() writes it.
struct Plot {
    std::string widget = {};  ///< its name, also in the names of its files: "energy error"
    std::string title = {};
    std::string x_name = "time [s]";
    std::string unit = {};  ///< of y
    bool logarithmic = false;
    std::string empty = {};  ///< shown if there is nothing to draw
    std::vector<Curve> curves = {};
};

/// Draws a plot into an area of the current ImGui window: axes, curves, legend, the values under the pointer, and a
/// button and a right-click menu that save it as CSV or PNG.
void draw_plot(const Context& context, const Plot& plot, const Area& area);

/// The data of a plot as CSV: a column for x and one for each curve; all curves have the same x.
std::string plot_csv(const Plot& plot);

/// The axes of a plot in a frame of pixels.
struct PlotAxes {
    Axis across;
    Axis up;
};
/// `most`: number of intervals between the ticks of the vertical axis, at most.
PlotAxes plot_axes(const Plot& plot, const Area& frame, int most = 5);
/// True if there is a value to draw.
bool has_values(const Plot& plot);

}  // namespace steplab::ui
