#pragma once

#include "plot/plot.hpp"
#include "ui/context.hpp"

namespace steplab::ui {

/// The plot of this kind, of what is known of the session.
plot::Plot plot_of(const Context& context, const PlotChoice& choice);

}  // namespace steplab::ui
