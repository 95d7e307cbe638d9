#include "ui/plot/draw_plot.hpp"

#include "core/number_text.hpp"
#include "ui/plot/plot_files.hpp"
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

float thickness_of(const Context& context) { return context.theme.scale() * 1.6f; }

void draw_solid(ImDrawList& list, const std::vector<ImVec2>& corners, ImU32 ink, float thickness) {
    // ImGui's indices have 16 bits; a thick line takes up to 6 vertices per point.
    constexpr std::size_t most = 8192;
    for (std::size_t from = 0; from + 1 < corners.size(); from += most - 1) {
        const std::size_t count = std::min(most, corners.size() - from);
        list.AddPolyline(corners.data() + from, static_cast<int>(count), ink, 0, thickness);
    }
}

void draw_line(ImDrawList& list, const std::vector<ImVec2>& corners, plot::Line line, ImU32 ink, float thickness) {
    if (line == plot::Line::none) return;
    if (line == plot::Line::solid) return draw_solid(list, corners, ink, thickness);
    draw_dashes(list, corners, plot::dashes_of(line), ink, thickness);
}

void draw_ticks(const plot::Layout& layout) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Area& frame = layout.frame;
    const auto draw_label = [](const plot::PlacedTick& tick) {
        text_left(tick.place.x, tick.place.y + 0.5f * tick.place.height, tick.label, colour::text_dim);
    };
    for (const plot::PlacedTick& tick : layout.up) {
        list.AddLine({frame.x, tick.pixel}, {frame.right(), tick.pixel}, colour::line);
        draw_label(tick);
    }
    for (const plot::PlacedTick& tick : layout.across) {
        list.AddLine({tick.pixel, frame.y}, {tick.pixel, frame.bottom()}, colour::line);
        draw_label(tick);
    }
}

/// Dots at the points where they are few enough to be told apart.
void draw_marks(ImDrawList& list, const std::vector<ImVec2>& corners, ImU32 ink, float radius) {
    for (const ImVec2& corner : corners) list.AddCircleFilled(corner, radius, ink);
}

void draw_curve(ImDrawList& list, const Context& context, const Curve& curve, const plot::Layout& layout) {
    std::vector<ImVec2> corners;
    for (const plot::Point& point : plot::decimated(curve.x, curve.y, layout.axes))
        corners.emplace_back(point.x, point.y);
    const ImU32 ink = ink_of(context, curve.colour);
    draw_line(list, corners, curve.line, ink, thickness_of(context));
    const bool few = static_cast<float>(corners.size()) < layout.frame.width / context.px(12);
    if (curve.large) draw_marks(list, corners, ink, context.px(5));
    if (curve.has_marks(few)) draw_marks(list, corners, ink, context.px(2.4f));
}

/// What was done, and where the run stands, as vertical lines.
void draw_moments(ImDrawList& list, const Context& context, const Plot& plot, const plot::Layout& layout) {
    const Area& frame = layout.frame;
    const WithFont font(context.theme.fonts().tiny);
    float free_from = frame.x;
    for (const plot::Moment& moment : plot.moments) {
        const float x = std::round(layout.axes.across.pixel(moment.x));
        if (x < frame.x || x > frame.right()) continue;
        list.AddLine({x, frame.y}, {x, frame.bottom()}, colour::text_faint);
        const float width = ImGui::CalcTextSize(moment.text.c_str()).x + context.px(6);
        if (x < free_from || x + width > frame.right()) continue;
        text_left(x + context.px(3), frame.bottom() - context.px(8), moment.text, colour::text_faint);
        free_from = x + width;
    }
    if (!plot.now) return;
    const float x = std::round(layout.axes.across.pixel(*plot.now));
    list.AddLine({x, frame.y}, {x, frame.bottom()}, colour::accent);
}

ImU32 area_ink(const Context& context, const plot::Band& band) {
    constexpr ImU32 alpha = 0x38;
    return (ink_of(context, band.colour) & ~IM_COL32_A_MASK) | alpha << IM_COL32_A_SHIFT;
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

void draw_curves(const Context& context, const Plot& plot, const plot::Layout& layout) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Area& frame = layout.frame;
    const float thickness = thickness_of(context);
    list.PushClipRect({frame.x, frame.y - thickness}, {frame.right() + 1, frame.bottom() + thickness}, true);
    for (const plot::Band& band : plot.bands) draw_band(list, context, band, layout);
    draw_moments(list, context, plot, layout);
    for (const Curve& curve : plot.curves) draw_curve(list, context, curve, layout);
    list.PopClipRect();
}

/// Where the name of a curve or band stands in the legend: its right end, and the middle of its line.
struct LegendPlace {
    const std::string* name;
    const Curve* curve;                 ///< null: of a band
    const plot::Band* band;             ///< null: of a curve
    float right = 0, y = 0, width = 0;  ///< width: with the sample of its line
};

/// From right to left and in as many rows as it takes, the last curve first.
std::vector<LegendPlace> legend_places(const Context& context, const Plot& plot, const Area& frame, float top) {
    const float row = ImGui::GetTextLineHeight() + context.px(2), last = frame.right() - context.px(8);
    std::vector<LegendPlace> places;
    float right = last, y = top + 0.5f * row;
    const auto add = [&](const std::string& name, const Curve* curve, const plot::Band* band) {
        const float width = ImGui::CalcTextSize(name.c_str()).x + context.px(27);
        if (right - width < frame.x && right < last) {
            right = last;
            y += row;
        }
        places.push_back({&name, curve, band, right, y, width});
        right -= width + context.px(12);
    };
    for (const plot::Band& band : plot.bands) add(band.name, nullptr, &band);
    for (auto curve = plot.curves.rbegin(); curve != plot.curves.rend(); ++curve) {
        if (curve->in_legend) add(curve->name, &*curve, nullptr);
    }
    return places;
}

/// What a curve or band looks like.
void draw_sample(ImDrawList& list, const Context& context, const LegendPlace& place) {
    const float from = place.right - place.width, to = from + context.px(22);
    if (place.band)
        return list.AddRectFilled({from, place.y - context.px(4)}, {to, place.y + context.px(4)},
                                  area_ink(context, *place.band));
    const Curve& curve = *place.curve;
    const ImU32 ink = ink_of(context, curve.colour);
    draw_line(list, {{from, place.y}, {to, place.y}}, curve.line, ink, thickness_of(context));
    if (curve.line == plot::Line::none) draw_marks(list, {{0.5f * (from + to), place.y}}, ink, context.px(2.4f));
}

/// For each curve a short line in its style and its name, on a card near the top of the frame. Where it would cover
/// most of the curves it is left out: the list of runs has the same lines, and the pointer tells the names.
void draw_legend(const Context& context, const Plot& plot, const Area& frame, float top) {
    if (plot.curves.size() + plot.bands.size() < 2) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const WithFont font(context.theme.fonts().small);
    const std::vector<LegendPlace> places = legend_places(context, plot, frame, top);
    if (places.empty()) return;
    const float half = 0.5f * ImGui::GetTextLineHeight() + context.px(2);
    float left = frame.right();
    for (const LegendPlace& place : places) left = std::min(left, place.right - place.width);
    const bool covers_most =
        frame.right() - left > 0.55f * frame.width && places.back().y + half - frame.y > 0.35f * frame.height;
    if (covers_most && !context.is_saved()) return;
    list.AddRectFilled({left - context.px(5), places.front().y - half}, {frame.right() - 1, places.back().y + half},
                       colour::card, context.px(4));
    for (const LegendPlace& place : places) {
        text_right(place.right, place.y, *place.name, colour::text_dim);
        draw_sample(list, context, place);
    }
}

/// The point of a curve that the pointer is at: the one over it or, where x does not ascend, the nearest in pixels.
std::size_t point_at(const Curve& curve, const plot::Axes& axes, ImVec2 pointer) {
    if (curve.ascending) return plot::nearest(curve.x, axes.across.value(pointer.x));
    const auto distance = [&](std::size_t i) {
        return std::hypot(axes.across.pixel(curve.x[i]) - pointer.x, axes.up.pixel(curve.y[i]) - pointer.y);
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < curve.x.size(); ++i) {
        if (distance(i) < distance(best)) best = i;
    }
    return best;
}

/// The ends of the bands over the pointer.
std::string bands_at(const Plot& plot, double x) {
    std::string text;
    for (const plot::Band& band : plot.bands) {
        if (band.x.empty()) continue;
        const std::size_t i = plot::nearest(band.x, x);
        text += fmt::format("\n{}: {} to {}", band.name, setting_text(band.low[i], 5),
                            with_unit(setting_text(band.high[i], 5), plot.y.unit));
    }
    return text;
}

/// A vertical line at the pointer, and the values of the curves there.
void draw_values_under_pointer(const Context& context, const Plot& plot, const plot::Layout& layout, const Area& area) {
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const auto& [across, up] = layout.axes;
    if (!layout.frame.contains(pointer.x, pointer.y)) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = std::round(pointer.x);
    list.AddLine({line, layout.frame.y}, {line, layout.frame.bottom()}, colour::text_faint);
    std::string text = plot.x.name + " " + with_unit(setting_text(across.value(pointer.x), 6), plot.x.unit);
    for (const Curve& curve : plot.curves) {
        if (curve.x.empty()) continue;
        const std::size_t i = point_at(curve, layout.axes, pointer);
        if (!std::isfinite(curve.y[i])) continue;
        if (up.can_show(curve.y[i]))
            list.AddCircleFilled({across.pixel(curve.x[i]), up.pixel(curve.y[i])}, context.theme.scale() * 3,
                                 ink_of(context, curve.colour));
        text.append("\n" + curve.name + ": " + with_unit(setting_text(curve.y[i], 5), plot.y.unit));
    }
    text += bands_at(plot, across.value(pointer.x));
    tooltip_beside(context, {pointer.x, area.y, pointer.x, area.bottom()}, text);
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

void draw_save_menu(const Context& context, const Plot& plot, const Area& area) {
    if (!ImGui::BeginPopup("save")) return;
    close_if_asked(context);
    if (ImGui::MenuItem("Save as CSV")) save_table(context, plot);
    context.mark(plot.name + ".csv");
    if (ImGui::MenuItem("Save as SVG")) save_drawing(context, plot);
    context.mark(plot.name + ".svg");
    if (ImGui::MenuItem("Save as PNG")) save_snapshot(context, plot, area);
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

/// The name of the axis across; beside it, in a picture that is saved, of what run the plot is.
void draw_axis_name(const Context& context, const Plot& plot, const Area& area, const Area& frame) {
    const WithFont font(context.theme.fonts().small);
    const std::string name = text_of(plot.x);
    const float width = ImGui::CalcTextSize(name.c_str()).x;
    const float y = area.bottom() - context.px(12), right = frame.right();
    const std::string& caption = context.is_saved() ? plot.caption : std::string();
    if (ImGui::CalcTextSize(caption.c_str()).x + width + context.px(20) < frame.width && !caption.empty()) {
        text_left(frame.x, y, caption, colour::text_faint);
        return text_right(right, y, name, colour::text_dim);
    }
    text_left(frame.x + 0.5f * (frame.width - width), y, name, colour::text_dim);
}

void draw_content(const Context& context, const Plot& plot, const Area& area, const plot::Layout& layout,
                  bool title_in_frame) {
    {
        const WithFont font(context.theme.fonts().small);
        draw_ticks(layout);
    }
    draw_axis_name(context, plot, area, layout.frame);
    draw_curves(context, plot, layout);
    draw_legend(context, plot, layout.frame, layout.frame.y + context.px(title_in_frame ? 20 : 4));
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
    const ImFont& font = *theme.fonts().small;
    const auto width = [&font](const std::string& text) {
        return font.CalcTextSizeA(font.FontSize, 1e9f, 0, text.c_str()).x;
    };
    return plot::layout_of(plot, area, {width, font.FontSize, theme.px(1)});
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
        draw_empty(context, plot, frame);
    }
    draw_save_menu(context, plot, area);
}

}  // namespace steplab::ui
