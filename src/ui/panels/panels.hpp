#pragma once

#include "ui/context.hpp"

#include <span>

namespace steplab::ui {

/// The panels, each in a file of its name. They draw one frame from the context and send the user's events to
/// context.events.

void draw_top_bar(const Context& context);
/// The menu button at the cursor of the bar and, if open, the menu.
void draw_menu(const Context& context);
/// All of `sections`, with a scroll bar if the window is too low for them; in a low window those of the chosen tab.
void draw_side_panel(const Context& context);
/// The tabs above it, in a low window.
void draw_panel_tabs(const Context& context);
void draw_scene_panel(const Context& context);
/// The list of runs, if there are several.
void draw_runs_panel(const Context& context);
/// Of a trajectory, in place of those of a run.
void draw_playback_panel(const Context& context);
void draw_method_panel(const Context& context);
void draw_step_panel(const Context& context);
void draw_show_panel(const Context& context);
/// Rows of the previous section.
void draw_ensemble_rows(const Context& context);
void draw_energy_panel(const Context& context);
void draw_selection_panel(const Context& context);
void draw_plots_panel(const Context& context);
/// The page of the lesson that is open: its text, and the buttons that do its part and turn the pages.
void draw_lesson_panel(const Context& context);
/// What the pointer drags to make panel and plots larger or smaller.
void draw_edges(const Context& context);

/// A part of the side panel, and the tab that it is in where the window is low.
struct Section {
    void (*draw)(const Context& context);
    PanelTab tab;
};
/// From top to bottom.
inline constexpr Section sections[] = {{draw_scene_panel, PanelTab::scene},    {draw_runs_panel, PanelTab::runs},
                                       {draw_method_panel, PanelTab::method},  {draw_step_panel, PanelTab::method},
                                       {draw_show_panel, PanelTab::display},   {draw_energy_panel, PanelTab::state},
                                       {draw_selection_panel, PanelTab::state}};
/// Those while a trajectory is played.
inline constexpr Section playback_sections[] = {{draw_scene_panel, PanelTab::scene},
                                                {draw_playback_panel, PanelTab::scene},
                                                {draw_show_panel, PanelTab::display},
                                                {draw_energy_panel, PanelTab::state}};
/// Those that are shown now.
std::span<const Section> sections_of(const Context& context);

/// In place of all of these and the scene: pictures of scenes to choose from, or the list of lessons.
void draw_scenes_page(const Context& context);
/// The lessons on that page.
void draw_lesson_list(const Context& context);

/// Over the scene: the ring around the particle under the pointer, and its numbers; the spring by which one is pulled,
/// the arrow of a kick, the box that selects; readings of time, step and errors; messages; the
/// cards of a scene out of view and of a diverged run; help.
void draw_pointed(const Context& context);
void draw_hands(const Context& context);
void draw_lost_card(const Context& context);
void draw_read_out(const Context& context);
void draw_notices(const Context& context);
void draw_time_line(const Context& context);
/// The buttons beside the time line.
void draw_run_buttons(const Context& context);
void draw_divergence_card(const Context& context);
void draw_help(const Context& context);

}  // namespace steplab::ui
