#pragma once

#include "ui/context.hpp"

namespace steplab::ui {

/// The panels, one per file of its name. Each draws one frame of itself from the context and sends what the person asks
/// for to the context's commands.

void draw_top_bar(const Context& context);
/// The button of the menu and, when open, the menu; at the cursor of the bar.
void draw_menu(const Context& context);
/// The sections below, one under another, with a scroll bar where the window is too low for them.
void draw_side_panel(const Context& context);
void draw_scene_panel(const Context& context);
void draw_method_panel(const Context& context);
void draw_step_panel(const Context& context);
void draw_show_panel(const Context& context);
/// Rows of the section above.
void draw_ensemble_rows(const Context& context);
void draw_energy_panel(const Context& context);
/// Measured rates, along the foot of the side panel.
void draw_footer(const Context& context);
void draw_plots_panel(const Context& context);

/// Over the scene: time, step and errors; what just happened; why a change was refused; why the run ended.
void draw_read_out(const Context& context);
void draw_notices(const Context& context);
void draw_divergence_card(const Context& context);
void draw_help(const Context& context);

}  // namespace steplab::ui
