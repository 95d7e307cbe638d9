#pragma once

#include "plot/layout.hpp"
#include "ui/context.hpp"

namespace steplab::ui {

/// Draws a plot into an area of the current ImGui window: axes, curves, legend, the values under the pointer, and a
/// right-click menu that saves it as CSV, SVG or PNG. Above the frame, the room for the title is left to the caller.
void draw_plot(const Context& context, const plot::Plot& plot, const Area& area, bool title_in_frame);

/// The layout of a plot within an area, in the small font.
plot::Layout plot_layout(const Theme& theme, const plot::Plot& plot, const Area& area);

/// A colour of a curve in the present theme.
ImU32 ink_of(const Context& context, std::size_t colour);

}  // namespace steplab::ui
