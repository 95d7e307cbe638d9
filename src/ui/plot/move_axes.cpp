#include "ui/plot/move_axes.hpp"

#include "ui/input.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

/// True if an axis can show that range, and numbers differ within it.
bool is_usable(Range range, plot::Scale scale) {
    const double size = std::max(std::abs(range.low), std::abs(range.high)), length = range.high - range.low;
    if (scale == plot::Scale::logarithmic && !(range.low > 0)) return false;
    return std::isfinite(length) && length > 1e-9 * size && length > 1e-300;
}

/// What is done with an axis: it is zoomed about a place, or drawn along; in pixels along it.
struct Gesture {
    bool resets = false;
    float lines = 0, at = 0;  ///< of the wheel, where the pointer is
    float moved = 0;
};

/// Keys do what the pointer does in the middle of an axis.
Gesture gesture_of_keys(const plot::Axis& axis) {
    const auto pressed = [](Key key) { return Input::pressed(key, true) ? 1.0f : 0.0f; };
    const float part = 0.1f * (axis.to - axis.from);
    return {Input::pressed(Key::home, false), pressed(Key::equal) - pressed(Key::minus), 0.5f * (axis.from + axis.to),
            part * (pressed(Key::bracket_left) - pressed(Key::bracket_right))};
}

/// In pixels, so that every scale is moved as it is seen.
void move_axis(const plot::Axis& axis, const Gesture& gesture, std::optional<Range>& shown) {
    float from = axis.from, to = axis.to;
    if (gesture.resets) return shown.reset();
    if (gesture.lines != 0) {
        const float factor = std::pow(0.8f, gesture.lines);
        from = gesture.at + factor * (from - gesture.at);
        to = gesture.at + factor * (to - gesture.at);
    } else if (gesture.moved != 0) {
        from -= gesture.moved;
        to -= gesture.moved;
    } else {
        return;
    }
    const Range moved{axis.value(from), axis.value(to)};
    if (is_usable(moved, axis.scale)) shown = moved;
}

bool is_over(const Area& area, ImVec2 point) { return area.contains(point.x, point.y); }

}  // namespace

void move_axes(const Context& context, const plot::Plot& plot, const plot::Layout& layout, const Area& area,
               PlotChoice& choice, bool steered) {
    const Area labels{area.x, layout.frame.y, layout.frame.x - area.x, layout.frame.height};
    context.mark(plot.name + ".axis", {labels.x, labels.y, labels.right(), labels.bottom()});
    if (context.purpose != Purpose::use || !plot::has_values(plot)) return;
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    const auto over = [&](const Area& where) { return hovered && is_over(where, io.MousePos); };
    const auto held = [&](const Area& where) {
        return ImGui::IsMouseDragging(0) && is_over(where, io.MouseClickedPos[0]);
    };
    const auto gesture = [&](const Area& where, float at, float moved) {
        return Gesture{over(where) && ImGui::IsMouseDoubleClicked(0), over(where) ? io.MouseWheel : 0, at,
                       held(where) ? moved : 0};
    };
    const auto& [across, up] = layout.axes;
    std::optional<Range>& shown_across = plot.x.name == "time" ? context.state.plots.window : choice.across;
    if (steered && io.KeyShift) move_axis(up, gesture_of_keys(up), choice.up);
    if (steered && !io.KeyShift) move_axis(across, gesture_of_keys(across), shown_across);
    move_axis(across, gesture(layout.frame, io.MousePos.x, io.MouseDelta.x), shown_across);
    move_axis(up, gesture(labels, io.MousePos.y, io.MouseDelta.y), choice.up);
    if (over(labels) || held(labels)) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
}

}  // namespace steplab::ui
