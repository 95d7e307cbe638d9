#include "ui/plot/plot.hpp"

#include "core/number_text.hpp"
#include "ui/plot/plot_files.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/icons.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

/// A dashed line through the points, with dashes and gaps of `length` pixels.
void draw_dashed(ImDrawList& list, const std::vector<PlotPoint>& points, ImU32 ink, float thickness, float length) {
    float along = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const PlotPoint a = points[i - 1];
        const PlotPoint b = points[i];
        const float piece = std::hypot(b.x - a.x, b.y - a.y);
        for (float from = 0; from < piece;) {
            const float phase = std::fmod(along + from, 2 * length);
            const float to = std::min(piece, from + (phase < length ? length : 2 * length) - phase);
            const auto at = [&](float s) {
                return ImVec2(a.x + (b.x - a.x) * s / piece, a.y + (b.y - a.y) * s / piece);
            };
            if (phase < length) list.AddLine(at(from), at(to), ink, thickness);
            from = to + 1e-3f;
        }
        along += piece;
    }
}

void draw_line(ImDrawList& list, const std::vector<PlotPoint>& points, ImU32 ink, float thickness) {
    // ImGui's indices have 16 bits; a thick line takes up to 6 vertices per point.
    constexpr std::size_t most = 8192;
    std::vector<ImVec2> corners;
    corners.reserve(points.size());
    for (const PlotPoint& point : points) corners.emplace_back(point.x, point.y);
    for (std::size_t from = 0; from + 1 < corners.size(); from += most - 1) {
        const std::size_t count = std::min(most, corners.size() - from);
        list.AddPolyline(corners.data() + from, static_cast<int>(count), ink, 0, thickness);
    }
}

int intervals_up(const Context& context, const Area& frame) {
    return std::max(2, static_cast<int>(std::lround(frame.height / context.px(32))));
}

void draw_grid(const Context& context, const PlotAxes& axes, const Area& frame) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const WithFont font(context.theme.fonts().small);
    const float half = 0.5f * ImGui::GetTextLineHeight();
    for (const Tick& tick : ticks(axes.up, intervals_up(context, frame))) {
        const float y = std::round(axes.up.pixel(tick.value));
        list.AddLine({frame.x, y}, {frame.right(), y}, colour::line);
        text_right(frame.x - context.px(7), y, tick.label, colour::text_dim);
    }
    const int most_across = std::max(2, static_cast<int>(frame.width / context.px(80)));
    for (const Tick& tick : ticks(axes.across, most_across)) {
        const float x = std::round(axes.across.pixel(tick.value));
        list.AddLine({x, frame.y}, {x, frame.bottom()}, colour::line);
        const float width = ImGui::CalcTextSize(tick.label.c_str()).x;
        text_left(x - 0.5f * width, frame.bottom() + context.px(4) + half, tick.label, colour::text_dim);
    }
}

void draw_curves(const Context& context, const Plot& plot, const PlotAxes& axes, const Area& frame) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float thickness = context.theme.scale() * 1.6f;
    list.PushClipRect({frame.x, frame.y - thickness}, {frame.right() + 1, frame.bottom() + thickness}, true);
    for (const Curve& curve : plot.curves) {
        const auto points = decimated(curve.x, curve.y, axes.across, axes.up);
        if (curve.dashed) {
            draw_dashed(list, points, curve.ink, thickness, context.px(5));
        } else {
            draw_line(list, points, curve.ink, thickness);
        }
    }
    list.PopClipRect();
}

/// The names of the curves and, before each, 5 units of space, a line and more space: 35 in all.
float legend_width(const Context& context, const Plot& plot) {
    const WithFont font(context.theme.fonts().small);
    float width = 0;
    for (const Curve& curve : plot.curves) width += ImGui::CalcTextSize(curve.name.c_str()).x + context.px(35);
    return width;
}

/// For each curve a short line in its style and its name, right-aligned: beside the title or, without room, in the
/// frame.
void draw_legend(const Context& context, const Plot& plot, const Area& area, const Area& frame) {
    if (plot.curves.size() < 2) return;
    const ImFont& title_font = *context.theme.fonts().heading;
    const float title = title_font.CalcTextSizeA(title_font.FontSize, 1e9f, 0, plot.title.c_str()).x;
    const float room = area.width - context.px(14 + 46) - title;
    const bool beside_title = legend_width(context, plot) <= room;
    float right = beside_title ? area.right() - context.px(46) : frame.right() - context.px(4);
    const float y = beside_title ? area.y + context.px(17) : frame.y + context.px(10);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const WithFont font(context.theme.fonts().small);
    const float thickness = context.theme.scale() * 1.6f;
    for (auto curve = plot.curves.rbegin(); curve != plot.curves.rend(); ++curve) {
        text_right(right, y, curve->name, colour::text_dim);
        right -= ImGui::CalcTextSize(curve->name.c_str()).x + context.px(5);
        const std::vector<PlotPoint> sample = {{right - context.px(18), y}, {right, y}};
        if (curve->dashed) {
            draw_dashed(list, sample, curve->ink, thickness, context.px(4));
        } else {
            draw_line(list, sample, curve->ink, thickness);
        }
        right -= context.px(30);
    }
}

/// A vertical line at the pointer, and the values of the curves there.
void draw_values_under_pointer(const Context& context, const Plot& plot, const PlotAxes& axes, const Area& frame) {
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    if (!frame.contains(pointer.x, pointer.y) || plot.curves.front().x.empty()) return;
    const Curve& first = plot.curves.front();
    const std::size_t i = nearest(first.x, axes.across.value(pointer.x));
    const float x = std::round(axes.across.pixel(first.x[i]));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine({x, frame.y}, {x, frame.bottom()}, colour::text_faint);
    std::string text = "t = " + with_unit(setting_text(first.x[i], 6), "s");
    for (const Curve& curve : plot.curves) {
        if (!std::isfinite(curve.y[i])) continue;
        if (!plot.logarithmic || curve.y[i] > 0) {
            list.AddCircleFilled({x, axes.up.pixel(curve.y[i])}, context.theme.scale() * 3, curve.ink);
        }
        text.append("\n" + curve.name + ": " + with_unit(setting_text(curve.y[i], 5), plot.unit));
    }
    tooltip(context, text);
}

void draw_empty(const Context& context, const Plot& plot, const Area& frame) {
    const WithFont font(context.theme.fonts().small);
    const float width = ImGui::CalcTextSize(plot.empty.c_str()).x;
    text_left(frame.x + 0.5f * (frame.width - width), frame.y + 0.5f * frame.height, plot.empty, colour::text_faint);
}

void draw_save_menu(const Context& context, const Plot& plot, const Area& area) {
    if (!ImGui::BeginPopup("save")) return;
    if (ImGui::MenuItem("Save as CSV")) save_table(context, plot);
    context.mark(plot.widget + ".csv");
    if (ImGui::MenuItem("Save as PNG")) save_snapshot(context, plot, area);
    context.mark(plot.widget + ".png");
    ImGui::EndPopup();
}

/// The frame of the plot within its card, with room for the title above and the labels at the left and below.
Area frame_of(const Context& context, const Area& area) {
    const Area frame{area.x + context.px(52), area.y + context.px(34), area.width - context.px(68),
                     area.height - context.px(34) - context.px(42)};
    return {std::round(frame.x), std::round(frame.y), std::round(frame.width), std::round(frame.height)};
}

void draw_title(const Context& context, const Plot& plot, const Area& area) {
    const WithFont font(context.theme.fonts().heading);
    text_left(area.x + context.px(14), area.y + context.px(17), plot.title, colour::text);
}

void draw_axis_name(const Context& context, const Plot& plot, const Area& area, const Area& frame) {
    const WithFont font(context.theme.fonts().small);
    const float width = ImGui::CalcTextSize(plot.x_name.c_str()).x;
    text_left(frame.x + 0.5f * (frame.width - width), area.bottom() - context.px(12), plot.x_name, colour::text_dim);
}

}  // namespace

void draw_plot(const Context& context, const Plot& plot, const Area& area) {
    const WithId id(plot.widget);
    const Area frame = frame_of(context, area);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({area.x, area.y}, {area.right(), area.bottom()}, colour::panel, context.px(5));
    list.AddRect({area.x, area.y}, {area.right(), area.bottom()}, colour::line, context.px(5));
    draw_title(context, plot, area);

    ImGui::SetCursorScreenPos({area.right() - context.px(36), area.y + context.px(3)});
    const bool save =
        icon_button(context, plot.widget + ".save", Icon::save, "save the plot as CSV or PNG", ButtonStyle::quiet);
    ImGui::SetCursorScreenPos({frame.x, frame.y});
    ImGui::InvisibleButton("frame", {std::max(1.0f, frame.width), std::max(1.0f, frame.height)});
    context.mark(plot.widget);
    if (save || ImGui::IsItemClicked(1)) ImGui::OpenPopup("save");
    if (has_values(plot)) {
        const PlotAxes axes = plot_axes(plot, frame, intervals_up(context, frame));
        draw_grid(context, axes, frame);
        draw_axis_name(context, plot, area, frame);
        draw_curves(context, plot, axes, frame);
        draw_legend(context, plot, area, frame);
        ImGui::SetCursorScreenPos({frame.x, frame.y});
        draw_values_under_pointer(context, plot, axes, frame);
    } else {
        draw_empty(context, plot, frame);
    }
    draw_save_menu(context, plot, area);
}

}  // namespace steplab::ui
