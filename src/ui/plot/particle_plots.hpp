#pragma once

#include "plot/plot.hpp"
#include "ui/context.hpp"

namespace steplab::ui {

// Plots of the motion of the selected particles, along the axis in which the first one moves most.

void displacement_plot(plot::Plot& plot, const Context& context);
void position_plot(plot::Plot& plot, const Context& context);
void velocity_plot(plot::Plot& plot, const Context& context);
/// Velocity over displacement.
void phase_plot(plot::Plot& plot, const Context& context);
/// Amplitude over angular frequency, beside the frequencies of the normal modes of the scene.
void spectrum_plot(plot::Plot& plot, const Context& context);

}  // namespace steplab::ui
