#pragma once

#include "ui/plot/plot.hpp"

#include <string>
#include <vector>

namespace steplab::ui {

/// A tick of a plot and its label. All lengths in pixels of the display.
struct PlacedTick {
    float pixel = 0;    ///< of the grid line
    std::string label;  ///< empty where there is no room for it
    Area place;         ///< of the label
};

/// Where the parts of a plot are drawn.
struct PlotLayout {
    Area frame;  ///< of the curves
    PlotAxes axes;
    std::vector<PlacedTick> up;      ///< labels at the left of the frame
    std::vector<PlacedTick> across;  ///< labels below it
};

/// The layout of a plot within an area. The labels lie in the area and do not overlap each other: the left margin is as
/// wide as the labels there need, and there are as many ticks across as have room.
PlotLayout plot_layout(const Theme& theme, const Plot& plot, const Area& area);

}  // namespace steplab::ui
