#pragma once

#include "plot/plot.hpp"

#include <functional>
#include <string>
#include <vector>

namespace steplab::plot {

/// How texts of a plot are measured, in pixels.
struct Lettering {
    std::function<float(const std::string& text)> width;  ///< of a line
    float height = 12;
    float unit = 1;  ///< pixels of a unit in which margins are stated
};

/// How far ticks stand out of the frame, into the gap between it and the labels [units of the layout].
inline constexpr float tick_length = 3;

/// A tick of a plot and its label.
struct PlacedTick {
    float pixel = 0;    ///< of the grid line
    std::string label;  ///< empty where there is no room for it
    Box place;          ///< of the label
};

/// Where the parts of a plot are drawn.
struct Layout {
    Box frame;  ///< of the curves
    Axes axes;
    std::vector<PlacedTick> up;      ///< labels at the left of the frame
    std::vector<PlacedTick> across;  ///< labels below it
};

/// The layout of a plot within a box. The labels lie in the box and do not overlap each other: the left margin is as
/// wide as the labels there need, and there are as many ticks across as have room.
Layout layout_of(const Plot& plot, const Box& box, const Lettering& lettering);

}  // namespace steplab::plot
