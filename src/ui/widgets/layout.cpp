#include "ui/widgets/layout.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace steplab::ui {
namespace {

// Lengths in units of the layout.
constexpr float bar_height = 40;
constexpr float lesson_width = 310;
constexpr float narrowest_with_panel = 620;
constexpr float lowest_without_tabs = 600;
constexpr float tabs_height = 34;
constexpr float lowest_with_tabs = 176;  // of plots
constexpr float time_line_height = 34;
constexpr float lowest_with_time_line = 240;
constexpr float run_buttons_width = 360;
constexpr float narrowest_with_run_buttons = 640;

/// At least as much remains to the scene as the plots take.
float plots_height(float height, std::optional<double> wanted) {
    if (wanted) return std::min(static_cast<float>(*wanted), 0.5f * height);
    return std::clamp(0.285f * height, 150.0f, 380.0f);
}

/// The upper part of the panel for its tabs.
void take_tabs(Layout& layout, float height) {
    Area& panel = layout.panel;
    layout.panel_tabs = {panel.x, panel.y, panel.width, std::min(height, panel.height)};
    panel.y += layout.panel_tabs.height;
    panel.height -= layout.panel_tabs.height;
}

}  // namespace

Layout arrange(const Display& display, std::optional<bool> panel, const PanelSizes& sizes, bool lesson,
               std::size_t chosen_plots) {
    const float scale = display.scale;
    const float width = static_cast<float>(display.width);
    const float height = static_cast<float>(display.height);
    const auto px = [&](float units) { return std::round(units * scale); };

    Layout layout;
    layout.bar = {0, 0, width, std::min(px(bar_height), height)};
    const float below = height - layout.bar.height;
    const float beside = lesson ? std::min(px(lesson_width), std::round(0.5f * width)) : 0;
    if (lesson) layout.lesson = {width - beside, layout.bar.height, beside, below};
    const bool wide = width - beside >= px(narrowest_with_panel);
    if (panel.value_or(wide)) {
        const float most = wide ? 0.5f : 0.75f;  // of the window
        const float wanted = px(static_cast<float>(sizes.panel_width));
        layout.panel = {0, layout.bar.height, std::min(wanted, most * width), below};
        if (height < px(lowest_without_tabs)) take_tabs(layout, px(tabs_height));
    }

    layout.scene = {layout.panel.width, layout.bar.height, std::max(1.0f, width - beside - layout.panel.width), below};
    const int room = static_cast<int>(layout.scene.width / px(narrowest_plot));
    if (panel.value_or(true) && height >= px(lowest_with_plots) && room >= 1) {
        const bool tabs = chosen_plots > static_cast<std::size_t>(std::min(room, 4));
        const float plots = px(std::max(plots_height(height / scale, sizes.plots_height), tabs ? lowest_with_tabs : 0));
        layout.plots = {layout.scene.x, height - plots, layout.scene.width, plots};
        layout.plot_count = std::min(room, 4);
        layout.scene.height -= plots;
    }
    if (height >= px(lowest_with_time_line) && layout.scene.width >= px(narrowest_plot)) {
        layout.scene.height -= px(time_line_height);
        layout.time_line = {layout.scene.x, layout.scene.bottom(), layout.scene.width, px(time_line_height)};
        if (layout.scene.width >= px(narrowest_with_run_buttons)) {
            layout.time_line.width -= px(run_buttons_width);
            layout.run_buttons = {layout.time_line.right(), layout.time_line.y, px(run_buttons_width),
                                  layout.time_line.height};
        }
    }
    layout.bar_has_title = width >= px(1120);
    layout.bar_has_speed = width >= px(820);
    layout.bar_has_precision = width >= px(380);
    layout.bar_has_snapshot = width >= px(470);
    const bool speed_leaves_room = width >= px(970) && (!layout.bar_has_title || width >= px(1270));
    layout.bar_has_record = speed_leaves_room || (!layout.bar_has_speed && width >= px(620));
    return layout;
}

void put_plots_into_panel(Layout& layout) {
    if (layout.panel_tabs.empty() || !layout.plots.empty()) return;
    layout.plots = std::exchange(layout.panel, {});
    layout.plots_in_panel = true;
    layout.plot_count = 1;
}

Layout arrange_scene_alone(const Display& display) {
    Layout layout;
    layout.scene = {0, 0, static_cast<float>(display.width), static_cast<float>(display.height)};
    return layout;
}

Area below(const Display& upper, const Display& whole) {
    const auto top = static_cast<float>(upper.height);
    return {0, top, static_cast<float>(whole.width), static_cast<float>(whole.height) - top};
}

PixelRect pixels(const Area& area) {
    const int left = static_cast<int>(std::lround(area.x));
    const int top = static_cast<int>(std::lround(area.y));
    return {left, top, std::max(1, static_cast<int>(std::lround(area.right())) - left),
            std::max(1, static_cast<int>(std::lround(area.bottom())) - top)};
}

}  // namespace steplab::ui
