#pragma once

#include "plot/plot.hpp"
#include "ui/context.hpp"

namespace steplab::ui {

/// Potential and force of the pairs of the scene over their distance, with a dot at each present distance.
void pair_plot(plot::Plot& plot, const Context& context);

}  // namespace steplab::ui
