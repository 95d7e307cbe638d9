#pragma once

#include "plot/plot.hpp"

#include <string>

namespace steplab::plot {

/// The picture of a plot as a file of its own: SVG on white, 720 x 440 pixels, with title, axes, legend and caption.
/// The same plot gives the same bytes.
std::string svg(const Plot& plot);

}  // namespace steplab::plot
