#include "ui/plot/legend.hpp"

#include "plot/free_corner.hpp"
#include "ui/plot/draw_plot.hpp"
#include "ui/plot/plot_lines.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <string>

namespace steplab::ui {
namespace {

using plot::Curve;
using plot::Plot;

/// Where a curve or band stands on the card: its left end, and the middle of its line, both from the upper left corner
/// of the names.
struct LegendPlace {
    const std::string* name;
    const Curve* curve;                ///< null: of a band
    const plot::Band* band;            ///< null: of a curve
    float left = 0, y = 0, width = 0;  ///< width: with the sample of its line

    float right() const { return left + width; }
};

/// Between the left end of the sample of a line and the name.
float name_offset(const Context& context) { return context.px(27); }

float line_height(const Context& context) { return ImGui::GetTextLineHeight() + context.px(2); }

/// In the order of the curves, which is that of the list of runs, from left to right and in as many rows as it takes.
std::vector<LegendPlace> legend_places(const Context& context, const Plot& plot, float room) {
    std::vector<LegendPlace> places;
    if (plot.curves.size() + plot.bands.size() < 2) return places;
    const float row = line_height(context);
    float left = 0, y = 0.5f * row;
    const auto add = [&](const std::string& name, const Curve* curve, const plot::Band* band) {
        const float width = std::min(ImGui::CalcTextSize(name.c_str()).x + name_offset(context), room);
        if (left + width > room && left > 0) {
            left = 0;
            y += row;
        }
        places.push_back({&name, curve, band, left, y, width});
        left += width + context.px(12);
    };
    for (const Curve& curve : plot.curves) {
        if (curve.in_legend) add(curve.name, &curve, nullptr);
    }
    for (const plot::Band& band : plot.bands) add(band.name, nullptr, &band);
    return places;
}

/// What a curve or band looks like.
void draw_sample(const Context& context, const LegendPlace& place, float from, float y) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float to = from + context.px(22);
    if (place.band)
        return list.AddRectFilled({from, y - context.px(4)}, {to, y + context.px(4)}, area_ink(context, *place.band));
    const Curve& curve = *place.curve;
    const ImU32 ink = ink_of(context, curve.colour);
    draw_line(list, {{from, y}, {to, y}}, curve.line, ink, thickness_of(context));
    if (curve.line == plot::Line::none) draw_marks(list, {{0.5f * (from + to), y}}, ink, context.px(2.4f));
}

/// The card of a plot: what stands on it, and its size.
struct Card {
    std::vector<LegendPlace> places;
    float title = 0;  ///< its height; 0: there is none
    plot::Box size;

    bool empty() const { return places.empty() && title == 0; }
};

Card card_of(const Context& context, const Plot& plot, const Area& frame, bool with_title, bool with_names) {
    const float edge = context.px(5);
    Card card;
    if (with_names) card.places = legend_places(context, plot, frame.width - 2 * edge);
    float width = 0, height = 0;
    for (const LegendPlace& place : card.places) {
        width = std::max(width, place.right());
        height = place.y + 0.5f * line_height(context);
    }
    if (with_title && !plot.title.empty()) {
        card.title = line_height(context);
        width = std::max(width, ImGui::CalcTextSize(plot.title.c_str()).x);
        height += card.title;
    }
    card.size = {0, 0, std::min(width + 2 * edge, frame.width - 2), height + context.px(2)};
    return card;
}

/// True if names would cover most of the curves: the list of runs has the same lines, and the pointer tells the names.
bool covers_most(const Card& card, const Area& frame) {
    return card.size.width > 0.55f * frame.width && card.size.height > 0.35f * frame.height;
}

}  // namespace

void draw_legend(const Context& context, const Plot& plot, const plot::Layout& layout,
                 std::span<const std::vector<plot::Point>> lines, bool with_title) {
    const WithFont font(context.theme.fonts().small);
    const Area& frame = layout.frame;
    Card card = card_of(context, plot, frame, with_title, true);
    if (!card.places.empty() && covers_most(card, frame) && !context.is_saved())
        card = card_of(context, plot, frame, with_title, false);
    if (card.empty()) return;
    const float above = plot.moments.empty() ? 1 : context.px(16);  // their texts
    const auto [known, is_first] = context.state.plots.legends.try_emplace(plot.name);
    plot::Corner& corner = known->second;  // one that stands somewhere moves only where that is much better
    corner = plot::free_corner(lines, frame, card.size, above, corner, is_first ? 0 : context.px(30));
    const plot::Box box = plot::card_in(frame, corner, card.size.width, card.size.height, above);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({box.x, box.y}, {box.right(), box.bottom()}, colour::card, context.px(4));
    const float left = box.x + context.px(5), top = box.y + context.px(1);
    if (card.title > 0) {
        const std::string title = shortened(plot.title, box.right() - left - context.px(4));
        text_left(left, top + 0.5f * card.title, title, colour::text_faint);
    }
    const float half = 0.5f * line_height(context), offset = name_offset(context);
    for (const LegendPlace& place : card.places) {
        const float x = left + place.left, y = top + card.title + place.y;
        draw_sample(context, place, x, y);
        const float room = place.width - offset + 0.5f;  // half a pixel for rounding
        text_left(x + offset, y, shortened(*place.name, room), colour::text_dim);
        context.mark(plot.name + ".legend/" + *place.name, {x, y - half, x + place.width, y + half});
    }
}

}  // namespace steplab::ui
