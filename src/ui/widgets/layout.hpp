#pragma once

#include "ui/display.hpp"

#include <optional>

namespace steplab::ui {

/// A rectangle in pixels that widgets are laid out in.
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

/// Where everything is. Areas that are not shown are empty; none covers another.
struct Layout {
    Area bar;            ///< along the top
    Area panel;          ///< at the left
    Area plots;          ///< at the bottom of the scene
    Area scene;          ///< the rest
    int plot_count = 0;  ///< plots that have room beside each other
    bool bar_has_title = false;
    bool bar_has_speed = false;
    bool bar_has_precision = false;
    bool bar_has_picture = false;
};

/// Arranges the panels for a display: what has no room folds away. `panel` is whether a person wants panel and plots;
/// none: the panel is there where the window is wide enough for it.
Layout arrange(const Display& display, std::optional<bool> panel = std::nullopt);

/// The whole pixels of an area.
PixelRect pixels(const Area& area);

}  // namespace steplab::ui
