#include "ui/plot/plot.hpp"

#include "core/number_text.hpp"
#include "ui/plot/plot_files.hpp"
#include "ui/plot/plot_layout.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/icons.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

/// A dashed line through the points, with dashes and gaps of `length` pixels.
void draw_dashed(ImDrawList& list, const std::vector<PlotPoint>& points, ImU32 ink, float thickness, float length) {
    double along = 0;  // of the line before the piece; dash k is from 2 k to 2 k + 1 lengths
    for (std::size_t i = 1; i < points.size(); ++i) {
        const PlotPoint a = points[i - 1];
        const PlotPoint b = points[i];
        const double piece = std::hypot(b.x - a.x, b.y - a.y);
        const auto at = [&](double dash) {
            const auto part =
                static_cast<float>(std::clamp((dash * static_cast<double>(length) - along) / piece, 0.0, 1.0));
            return ImVec2(a.x + (b.x - a.x) * part, a.y + (b.y - a.y) * part);
        };
        const double last = (along + piece) / static_cast<double>(length);
        for (double dash = 2 * std::floor(along / static_cast<double>(2 * length)); piece > 0 && dash < last;
             dash += 2) {
            if ((dash + 1) * static_cast<double>(length) > along) list.AddLine(at(dash), at(dash + 1), ink, thickness);
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

void draw_grid(const Context& context, const PlotLayout& layout) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const WithFont font(context.theme.fonts().small);
    const Area& frame = layout.frame;
    const auto draw_label = [](const PlacedTick& tick) {
        text_left(tick.place.x, tick.place.y + 0.5f * tick.place.height, tick.label, colour::text_dim);
    };
    for (const PlacedTick& tick : layout.up) {
        list.AddLine({frame.x, tick.pixel}, {frame.right(), tick.pixel}, colour::line);
        draw_label(tick);
    }
    for (const PlacedTick& tick : layout.across) {
        list.AddLine({tick.pixel, frame.y}, {tick.pixel, frame.bottom()}, colour::line);
        draw_label(tick);
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
void draw_values_under_pointer(const Context& context, const Plot& plot, const PlotAxes& axes, const Area& area,
                               const Area& frame) {
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
    tooltip_beside(context, {pointer.x, area.y, pointer.x, area.bottom()}, text);
}

void draw_empty(const Context& context, const Plot& plot, const Area& frame) {
    const WithFont font(context.theme.fonts().small);
    const float width = ImGui::CalcTextSize(plot.empty.c_str()).x;
    text_left(frame.x + 0.5f * (frame.width - width), frame.y + 0.5f * frame.height, plot.empty, colour::text_faint);
}

void draw_save_menu(const Context& context, const Plot& plot, const Area& area) {
    if (!ImGui::BeginPopup("save")) return;
    close_if_asked(context);
    if (ImGui::MenuItem("Save as CSV")) save_table(context, plot);
    context.mark(plot.widget + ".csv");
    if (ImGui::MenuItem("Save as PNG")) save_snapshot(context, plot, area);
    context.mark(plot.widget + ".png");
    ImGui::EndPopup();
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

/// The button that saves the plot; pictures of the window have none.
bool save_button(const Context& context, const Plot& plot, const Area& area) {
    if (context.is_saved()) return false;
    ImGui::SetCursorScreenPos({area.right() - context.px(36), area.y + context.px(3)});
    return icon_button(context, plot.widget + ".save", Icon::save, "save the plot as CSV or PNG", ButtonStyle::quiet);
}

void draw_content(const Context& context, const Plot& plot, const Area& area, const PlotLayout& layout) {
    draw_grid(context, layout);
    draw_axis_name(context, plot, area, layout.frame);
    draw_curves(context, plot, layout.axes, layout.frame);
    draw_legend(context, plot, area, layout.frame);
    ImGui::SetCursorScreenPos({layout.frame.x, layout.frame.y});
    draw_values_under_pointer(context, plot, layout.axes, area, layout.frame);
}

}  // namespace

void draw_plot(const Context& context, const Plot& plot, const Area& area) {
    const WithId id(plot.widget);
    const PlotLayout layout = plot_layout(context.theme, plot, area);
    const Area& frame = layout.frame;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({area.x, area.y}, {area.right(), area.bottom()}, colour::panel, context.px(5));
    list.AddRect({area.x, area.y}, {area.right(), area.bottom()}, colour::line, context.px(5));
    draw_title(context, plot, area);

    const bool save = save_button(context, plot, area);
    ImGui::SetCursorScreenPos({frame.x, frame.y});
    ImGui::InvisibleButton("frame", {frame.width, frame.height});
    context.mark(plot.widget);
    if (save || ImGui::IsItemClicked(1)) ImGui::OpenPopup("save");
    if (has_values(plot)) {
        draw_content(context, plot, area, layout);
    } else {
        draw_empty(context, plot, frame);
    }
    draw_save_menu(context, plot, area);
}

}  // namespace steplab::ui
