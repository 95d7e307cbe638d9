#pragma once

#include "plot/plot.hpp"
#include "ui/display.hpp"
#include "ui/view_choices.hpp"

#include <optional>

namespace steplab::ui {

/// The least height of a window, and the least width of a plot, in units of the layout, with which there are plots
/// below the scene.
inline constexpr float lowest_with_plots = 460;
inline constexpr float narrowest_plot = 240;

/// A rectangle in pixels, for the layout of widgets.
using Area = plot::Box;

/// The areas of the window. Those that are not shown are empty; none overlaps another.
struct Layout {
    Area bar;            ///< along the top
    Area panel_tabs;     ///< above the panel, where the window is too low for all of its sections
    Area panel;          ///< at the left
    Area lesson;         ///< at the right
    Area time_line;      ///< below the scene
    Area run_buttons;    ///< beside it, where there is room
    Area plots;          ///< at the bottom
    Area scene;          ///< the rest
    int plot_count = 0;  ///< number of plots that fit next to each other
    bool plots_in_panel = false;
    bool bar_has_title = false;
    bool bar_has_speed = false;
    bool bar_has_precision = false;
    bool bar_has_snapshot = false;
    bool bar_has_record = false;

    /// Whether the panel is there, or the tab of the plots in its place.
    bool has_panel() const { return !panel.empty() || plots_in_panel; }
};

/// Arranges the panels for a display and hides those without room. `panel`: whether the user wants panel and plots;
/// none: the panel is shown where the window is wide enough. `lesson`: a lesson is open, beside everything below the
/// bar. `plots`: how many are chosen; where not all have room, their tabs have some.
Layout arrange(const Display& display, std::optional<bool> panel = std::nullopt, const PanelSizes& sizes = {},
               bool lesson = false, std::size_t plots = 1);

/// In place of the sections of a panel with tabs: a plot, where the window has no other room for plots.
void put_plots_into_panel(Layout& layout);

/// The scene fills the display.
Layout arrange_scene_alone(const Display& display);

/// What is left of a display below a smaller one.
Area below(const Display& upper, const Display& whole);

/// The area in whole pixels.
PixelRect pixels(const Area& area);

}  // namespace steplab::ui
