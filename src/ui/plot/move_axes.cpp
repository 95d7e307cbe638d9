#include "ui/plot/move_axes.hpp"

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

/// What the pointer does with an axis.
struct Gesture {
    bool over = false, held = false;  ///< the pointer is where the axis is moved, and was when it was pressed
    float at = 0, moved = 0;          ///< pixels along the axis
};

/// In pixels, so that every scale is moved as it is seen.
void move_axis(const plot::Axis& axis, const Gesture& gesture, std::optional<Range>& shown) {
    const ImGuiIO& io = ImGui::GetIO();
    float from = axis.from, to = axis.to;
    if (gesture.over && ImGui::IsMouseDoubleClicked(0)) return shown.reset();
    if (gesture.over && io.MouseWheel != 0) {
        const float factor = std::pow(0.8f, io.MouseWheel);
        from = gesture.at + factor * (from - gesture.at);
        to = gesture.at + factor * (to - gesture.at);
    } else if (gesture.held && gesture.moved != 0) {
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
               PlotChoice& choice) {
    const Area labels{area.x, layout.frame.y, layout.frame.x - area.x, layout.frame.height};
    context.mark(plot.name + ".axis", {labels.x, labels.y, labels.right(), labels.bottom()});
    if (context.purpose != Purpose::use || !plot::has_values(plot)) return;
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    const bool dragging = ImGui::IsMouseDragging(0);
    const auto gesture = [&](const Area& where, float at, float moved) {
        return Gesture{hovered && is_over(where, io.MousePos), dragging && is_over(where, io.MouseClickedPos[0]), at,
                       moved};
    };
    move_axis(layout.axes.across, gesture(layout.frame, io.MousePos.x, io.MouseDelta.x),
              plot.x.name == "time" ? context.state.plots.window : choice.across);
    const Gesture up = gesture(labels, io.MousePos.y, io.MouseDelta.y);
    move_axis(layout.axes.up, up, choice.up);
    if (up.over || up.held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
}

}  // namespace steplab::ui
