#pragma once

#include "ui/context.hpp"
#include "ui/plot/axis.hpp"

#include <string>
#include <vector>

namespace steplab::ui {

/// One line of a plot: y over x, x growing.
struct Curve {
    std::string name = {};  ///< in the legend and as the head of the CSV column
    ImU32 ink = colour::accent;
    bool dashed = false;
    std::vector<double> x = {};
    std::vector<double> y = {};  ///< what is not finite is a gap
};

/// What a plot shows. It is drawn by draw_plot() and written by plot_csv().
struct Plot {
    std::string widget = {};  ///< its name, also that of the files it is saved to: "energy error"
    std::string title = {};
    std::string x_name = "time [s]";
    std::string unit = {};  ///< of y
    bool logarithmic = false;
    std::string empty = {};  ///< shown where there is nothing to draw
    std::vector<Curve> curves = {};
};

/// Draws a plot into an area of the current ImGui window: axes, lines, legend, the values under the pointer, and a
/// button and right click that save it as a table or a picture.
void draw_plot(const Context& context, const Plot& plot, const Area& area);

/// The numbers of a plot: a column for x and one for each curve; all curves have the same x.
std::string plot_csv(const Plot& plot);

/// The axes a plot has in a frame of pixels.
struct PlotAxes {
    Axis across;
    Axis up;
};
/// `most` is the number of intervals that the ticks part the height into.
PlotAxes plot_axes(const Plot& plot, const Area& frame, int most = 5);
/// True if there is a value to draw.
bool has_values(const Plot& plot);

}  // namespace steplab::ui
