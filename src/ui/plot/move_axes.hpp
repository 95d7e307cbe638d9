#pragma once

#include "plot/layout.hpp"
#include "ui/context.hpp"

namespace steplab::ui {

/// Wheel and drag over a plot change the part of its axis across that is shown, of time in all plots; over the labels
/// at the left that of its axis up. A double click there shows all again. `area` is that of the whole plot.
void move_axes(const Context& context, const plot::Plot& plot, const plot::Layout& layout, const Area& area,
               PlotChoice& choice, bool steered);

}  // namespace steplab::ui
