#pragma once

#include "ui/display.hpp"

#include <optional>

namespace steplab::ui {

/// A rectangle in pixels, for the layout of widgets.
struct Area {
    float x = 0;
    float y = 0;
    float width = 0;
    float height = 0;
    float right() const { return x + width; }
    float bottom() const { return y + height; }
    bool empty() const { return width <= 0 || height <= 0; }
    bool contains(float px, float py) const { return px >= x && px < right() && py >= y && py < bottom(); }
};

/// The areas of the window. Those that are not shown are empty; none overlaps another.
struct Layout {
    Area bar;            ///< along the top
    Area panel;          ///< at the left
    Area time_line;      ///< below the scene
    Area run_buttons;    ///< beside it, where there is room
    Area plots;          ///< at the bottom
    Area scene;          ///< the rest
    int plot_count = 0;  ///< number of plots that fit next to each other
    bool bar_has_title = false;
    bool bar_has_speed = false;
    bool bar_has_precision = false;
    bool bar_has_snapshot = false;
};

/// Arranges the panels for a display and hides those without room. `panel`: whether the user wants panel and plots;
/// none: the panel is shown where the window is wide enough.
Layout arrange(const Display& display, std::optional<bool> panel = std::nullopt);

/// The area in whole pixels.
PixelRect pixels(const Area& area);

}  // namespace steplab::ui
