#include "ui/plot/draw_plot.hpp"

#include "core/number_text.hpp"
#include "plot/moment_labels.hpp"
#include "plot/pointed.hpp"
#include "ui/plot/legend.hpp"
#include "ui/plot/plot_files.hpp"
#include "ui/plot/plot_lines.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/icons.hpp"
#include "ui/widgets/run_marks.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

using plot::Curve;
using plot::Plot;

/// Grid lines, the box around them, ticks outside it and their labels.
void draw_axes(const Context& context, const plot::Layout& layout) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Area& frame = layout.frame;
    const float length = context.px(plot::tick_length);
    const auto draw_label = [](const plot::PlacedTick& tick) {
        text_left(tick.place.x, tick.place.y + 0.5f * tick.place.height, tick.label, colour::text_dim);
    };
    for (const plot::PlacedTick& tick : layout.up) {
        list.AddLine({frame.x, tick.pixel}, {frame.right(), tick.pixel}, colour::line);
        list.AddLine({frame.x - length, tick.pixel}, {frame.x, tick.pixel}, colour::text_faint);
        draw_label(tick);
    }
    for (const plot::PlacedTick& tick : layout.across) {
        list.AddLine({tick.pixel, frame.y}, {tick.pixel, frame.bottom()}, colour::line);
        list.AddLine({tick.pixel, frame.bottom()}, {tick.pixel, frame.bottom() + length}, colour::text_faint);
        draw_label(tick);
    }
    list.AddRect({frame.x, frame.y}, {frame.right() + 1, frame.bottom() + 1}, colour::text_faint);
}

void draw_curve(ImDrawList& list, const Context& context, const Curve& curve, const std::vector<plot::Point>& points,
                const plot::Layout& layout) {
    std::vector<ImVec2> corners;
    corners.reserve(points.size());
    for (const plot::Point& point : points) corners.emplace_back(point.x, point.y);
    const ImU32 ink = ink_of(context, curve.colour);
    draw_line(list, corners, curve.line, ink, thickness_of(context));
    // dots at the points where they are few enough to be told apart
    const bool few = plot::told_apart(points, layout.frame, context.px(12));
    if (curve.large) draw_marks(list, corners, ink, context.px(5));
    if (curve.has_marks(few)) draw_marks(list, corners, ink, context.px(2.4f));
}

plot::Lettering lettering_of(const Theme& theme, const ImFont& font) {
    const auto width = [&font](const std::string& text) {
        return font.CalcTextSizeA(font.FontSize, 1e9f, 0, text.c_str()).x;
    };
    return {width, font.FontSize, theme.scale()};
}

/// What was done, and where the run stands, as vertical lines.
void draw_moments(ImDrawList& list, const Context& context, const Plot& plot, const plot::Layout& layout,
                  const std::vector<plot::MomentLine>& moments) {
    const Area& frame = layout.frame;
    const WithFont font(context.theme.fonts().tiny);
    for (const plot::MomentLine& line : moments)
        list.AddLine({line.pixel, frame.y}, {line.pixel, frame.bottom()}, colour::text_faint);
    const float edge = context.px(2);
    for (const auto& [moment, pixel, label] : moments) {
        if (label.empty()) continue;
        list.AddRectFilled({label.x + edge, label.y}, {label.right() - edge, label.bottom()}, colour::panel);
        text_left(label.x + context.px(3), label.y + 0.5f * label.height, moment->text, colour::text_faint);
    }
    if (!plot.now) return;
    const float x = std::round(layout.axes.across.pixel(*plot.now));
    list.AddLine({x, frame.y}, {x, frame.bottom()}, colour::accent);
}

/// Quadrilateral by quadrilateral: as a whole it is not convex.
void draw_band(ImDrawList& list, const Context& context, const plot::Band& band, const plot::Layout& layout) {
    const std::vector<plot::Strip> strips = plot::strips(band, layout.axes);
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;  // whose soft edges would show where they meet
    for (std::size_t i = 1; i < strips.size(); ++i) {
        const plot::Strip &a = strips[i - 1], &b = strips[i];
        list.AddQuadFilled({a.x, a.top}, {b.x, b.top}, {b.x, b.bottom}, {a.x, a.bottom}, area_ink(context, band));
    }
    list.Flags = flags;
}

/// Where the curves run, in pixels.
using Lines = std::vector<std::vector<plot::Point>>;

Lines lines_of(const Plot& plot, const plot::Layout& layout) {
    Lines lines;
    for (const Curve& curve : plot.curves) lines.push_back(plot::decimated(curve.x, curve.y, layout.axes));
    return lines;
}

void draw_curves(const Context& context, const Plot& plot, const Lines& lines, const plot::Layout& layout,
                 const std::vector<plot::MomentLine>& moments) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Area& frame = layout.frame;
    const float thickness = thickness_of(context);
    list.PushClipRect({frame.x, frame.y - thickness}, {frame.right() + 1, frame.bottom() + thickness}, true);
    for (const plot::Band& band : plot.bands) draw_band(list, context, band, layout);
    draw_moments(list, context, plot, layout, moments);
    for (const std::size_t i : plot::drawing_order(plot)) draw_curve(list, context, plot.curves[i], lines[i], layout);
    list.PopClipRect();
}

/// The ends of the bands over the pointer.
std::string bands_at(const Plot& plot, const plot::Axes& axes, plot::Point pointer) {
    std::string text;
    for (const plot::Band& band : plot.bands) {
        const auto i = plot::place_at(band, axes, pointer);
        if (!i) continue;
        text += fmt::format("\n{}: {} to {}", band.name, setting_text(band.low[*i], 5),
                            with_unit(setting_text(band.high[*i], 5), plot.y.unit));
    }
    return text;
}

/// A dot on a curve, where that is seen.
void draw_dot(const Context& context, const Curve& curve, std::size_t i, const plot::Layout& layout) {
    const auto& [across, up] = layout.axes;
    if (!up.can_show(curve.y[i])) return;
    const Area& frame = layout.frame;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float radius = context.theme.scale() * 3;
    list.PushClipRect({frame.x - radius, frame.y - radius}, {frame.right() + radius, frame.bottom() + radius}, true);
    list.AddCircleFilled({across.pixel(curve.x[i]), up.pixel(curve.y[i])}, radius, ink_of(context, curve.colour));
    list.PopClipRect();
}

/// A vertical line at the pointer, and the values of the curves there.
void draw_values_under_pointer(const Context& context, const Plot& plot, const plot::Layout& layout, const Area& area) {
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    if (!layout.frame.contains(pointer.x, pointer.y)) return;
    const float line = std::round(pointer.x);
    ImGui::GetWindowDrawList()->AddLine({line, layout.frame.y}, {line, layout.frame.bottom()}, colour::text_faint);
    const std::vector<plot::PointedPoint> points = plot::points_at(plot, layout.axes, {pointer.x, pointer.y});
    const double across =
        points.empty() ? layout.axes.across.value(pointer.x) : points.front().curve->x[points.front().index];
    std::string text = plot.x.name + " " + with_unit(setting_text(across, 6), plot.x.unit);
    for (const plot::Moment* const moment : plot::moments_at(plot, layout.axes, pointer.x, context.px(3)))
        text += "\n" + moment->text;
    for (const auto& [curve, i] : points) {
        draw_dot(context, *curve, i, layout);
        text.append("\n" + curve->name + ": " + with_unit(setting_text(curve->y[i], 5), plot.y.unit));
    }
    text += bands_at(plot, layout.axes, {pointer.x, pointer.y});
    tooltip_beside(context, {pointer.x, area.y, pointer.x, area.bottom()}, text);
    context.mark(plot.name + ".values", {area.x, area.y, area.right(), area.bottom()});
}

/// In the middle of the frame, in as many lines as it takes.
void draw_empty(const Context& context, const Plot& plot, const Area& frame) {
    const WithFont font(context.theme.fonts().small);
    const float room = frame.width - context.px(12);
    const ImVec2 size = ImGui::CalcTextSize(plot.empty.c_str(), nullptr, false, room);
    const ImVec2 corner{frame.x + 0.5f * (frame.width - size.x), frame.y + 0.5f * (frame.height - size.y)};
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(), corner, colour::text_faint,
                                        plot.empty.c_str(), nullptr, room);
}

void draw_save_menu(const Context& context, const Plot& plot) {
    if (!ImGui::BeginPopup("save")) return;
    close_if_asked(context);
    if (ImGui::MenuItem("Save as CSV")) save_table(context, plot);
    context.mark(plot.name + ".csv");
    if (ImGui::MenuItem("Save as SVG")) save_drawing(context, plot);
    context.mark(plot.name + ".svg");
    if (ImGui::MenuItem("Save as PNG")) save_snapshot(context, plot);
    context.mark(plot.name + ".png");
    ImGui::EndPopup();
}

/// The button that saves the plot; pictures of the window have none.
bool save_button(const Context& context, const Plot& plot, const Area& area) {
    if (context.is_saved()) return false;
    ImGui::SetCursorScreenPos({area.right() - context.px(36), area.y + context.px(3)});
    return icon_button(context, plot.name + ".save", Icon::save, "save the plot as CSV, SVG or PNG",
                       ButtonStyle::quiet);
}

/// The name of the axis across in so much room, if need be without the part of it and what it says in brackets.
std::string name_across(const Plot& plot, float room) {
    plot::Quantity axis = plot.x;
    const auto is_too_long = [&] { return ImGui::CalcTextSize(text_of(axis).c_str()).x > room; };
    if (is_too_long()) axis.part.clear();
    if (is_too_long()) axis.name.resize(std::min(axis.name.size(), axis.name.find(" (")));
    return shortened(text_of(axis), room);
}

/// The name of the axis across; beside it, in a picture that is saved, of what run the plot is.
void draw_axis_name(const Context& context, const Plot& plot, const Area& area, const Area& frame) {
    const WithFont font(context.theme.fonts().small);
    const float left = area.x + context.px(8), right = frame.right();
    const float last = context.is_saved() ? right : right - context.px(62);  // beside the name lies the scale's button
    const std::string name = name_across(plot, last - left);
    const float width = ImGui::CalcTextSize(name.c_str()).x;
    const float y = area.bottom() - context.px(12);
    const std::string& caption = context.is_saved() ? plot.caption : std::string();
    if (ImGui::CalcTextSize(caption.c_str()).x + width + context.px(20) < frame.width && !caption.empty()) {
        text_left(frame.x, y, caption, colour::text_faint);
        return text_right(right, y, name, colour::text_dim);
    }
    text_left(std::min(frame.x + 0.5f * (frame.width - width), last - width), y, name, colour::text_dim);
}

void draw_content(const Context& context, const Plot& plot, const Area& area, const plot::Layout& layout,
                  bool title_in_frame) {
    {
        const WithFont font(context.theme.fonts().small);
        draw_axes(context, layout);
    }
    draw_axis_name(context, plot, area, layout.frame);
    const Lines lines = lines_of(plot, layout);
    const auto moments = plot::moment_lines(plot, layout, lettering_of(context.theme, *context.theme.fonts().tiny));
    draw_curves(context, plot, lines, layout, moments);
    draw_legend(context, plot, layout.frame, lines, plot::height_of_labels(moments, layout.frame), title_in_frame);
    ImGui::SetCursorScreenPos({layout.frame.x, layout.frame.y});
    if (context.purpose == Purpose::use && !plot.nearest_alone) draw_values_under_pointer(context, plot, layout, area);
}

}  // namespace

ImU32 ink_of(const Context& context, std::size_t colour) {
    if (colour == Curve::exact) return colour::exact;
    if (colour == Curve::quiet) return colour::text_faint;
    return run_ink(context.stage.style.background, colour);
}

plot::Layout plot_layout(const Theme& theme, const Plot& plot, const Area& area) {
    return plot::layout_of(plot, area, lettering_of(theme, *theme.fonts().small));
}

void draw_plot(const Context& context, const Plot& plot, const Area& area, bool title_in_frame) {
    const WithId id(plot.name);
    const plot::Layout layout = plot_layout(context.theme, plot, area);
    const Area& frame = layout.frame;
    const bool save = save_button(context, plot, area);
    ImGui::SetCursorScreenPos({frame.x, frame.y});
    ImGui::InvisibleButton("frame", {frame.width, frame.height});
    context.mark(plot.name);
    if (save || ImGui::IsItemClicked(1)) ImGui::OpenPopup("save");
    if (plot::has_values(plot)) {
        draw_content(context, plot, area, layout, title_in_frame);
    } else {
        draw_legend(context, plot, frame, {}, 0, title_in_frame);
        draw_empty(context, plot, frame);
    }
    draw_save_menu(context, plot);
}

}  // namespace steplab::ui
