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

/// How large a legend is, in pixels besides its font.
struct Size {
    float sample, offset, between, row;  ///< of a line; from there to the name; between names; height of a row
};

/// Small ones where usual ones would cover most of the curves; none where those would, too.
enum class Names { usual, small, none };

Size size_of(const Context& context, bool small) {
    const float row = ImGui::GetTextLineHeight() + context.px(small ? 0 : 2);
    return small ? Size{context.px(12), context.px(15), context.px(7), row}
                 : Size{context.px(22), context.px(27), context.px(12), row};
}

/// In the order of the curves, which is that of the list of runs, from left to right and in as many rows as it takes.
std::vector<LegendPlace> legend_places(const Plot& plot, const Size& size, float room) {
    std::vector<LegendPlace> places;
    if (plot.curves.size() + plot.bands.size() < 2) return places;
    float left = 0, y = 0.5f * size.row;
    const auto add = [&](const std::string& name, const Curve* curve, const plot::Band* band) {
        const float width = std::min(ImGui::CalcTextSize(name.c_str()).x + size.offset, room);
        if (left + width > room && left > 0) {
            left = 0;
            y += size.row;
        }
        places.push_back({&name, curve, band, left, y, width});
        left += width + size.between;
    };
    for (const Curve& curve : plot.curves) {
        if (curve.in_legend) add(curve.legend(), &curve, nullptr);
    }
    for (const plot::Band& band : plot.bands) add(band.name, nullptr, &band);
    return places;
}

/// What a curve or band looks like.
void draw_sample(const Context& context, const LegendPlace& place, const Size& size, float from, float y) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float to = from + size.sample;
    if (place.band)
        return list.AddRectFilled({from, y - context.px(4)}, {to, y + context.px(4)}, area_ink(context, *place.band));
    const Curve& curve = *place.curve;
    const ImU32 ink = ink_of(context, curve.colour);
    draw_line(list, {{from, y}, {to, y}}, curve.line, ink, thickness_of(context));
    if (curve.line == plot::Line::none) draw_marks(list, {{0.5f * (from + to), y}}, ink, context.px(2.4f));
}

/// The card of a plot: what stands on it, and its size.
struct Card {
    Size of = {};
    std::vector<LegendPlace> places;
    float title = 0;  ///< its height; 0: there is none
    plot::Box size;

    bool empty() const { return places.empty() && title == 0; }
};

/// In the present font.
Card card_of(const Context& context, const Plot& plot, const Area& frame, bool with_title, Names names) {
    const float edge = context.px(5);
    Card card;
    card.of = size_of(context, names == Names::small);
    if (names != Names::none) card.places = legend_places(plot, card.of, frame.width - 2 * edge);
    float width = 0, height = 0;
    for (const LegendPlace& place : card.places) {
        width = std::max(width, place.right());
        height = place.y + 0.5f * card.of.row;
    }
    if (with_title && !plot.title.empty()) {
        card.title = card.of.row;
        width = std::max(width, ImGui::CalcTextSize(plot.title.c_str()).x);
        height += card.title;
    }
    card.size = {0, 0, std::min(width + 2 * edge, frame.width - 2), height + context.px(2)};
    return card;
}

bool covers_most(const Card& card, const Area& frame, float part) {
    return card.size.width > 0.55f * frame.width && card.size.height > part * frame.height;
}

/// Curves are seen through it.
ImU32 card_ink() {
    constexpr ImU32 alpha = 0xb8;
    return (colour::card & ~IM_COL32_A_MASK) | alpha << IM_COL32_A_SHIFT;
}

/// On a card at this place.
void draw_card(const Context& context, const Plot& plot, const Card& card, const plot::Box& box) {
    ImGui::GetWindowDrawList()->AddRectFilled({box.x, box.y}, {box.right(), box.bottom()}, card_ink(), context.px(4));
    const float left = box.x + context.px(5), top = box.y + context.px(1);
    if (card.title > 0) {
        const std::string title = shortened(plot.title, box.right() - left - context.px(4));
        text_left(left, top + 0.5f * card.title, title, colour::text_faint);
    }
    const float half = 0.5f * card.of.row, offset = card.of.offset;
    for (const LegendPlace& place : card.places) {
        const float x = left + place.left, y = top + card.title + place.y;
        draw_sample(context, place, card.of, x, y);
        const float room = place.width - offset + 0.5f;  // half a pixel for rounding
        text_left(x + offset, y, shortened(*place.name, room), colour::text_dim);
        context.mark(plot.name + ".legend/" + *place.name, {x, y - half, x + place.width, y + half});
    }
}

}  // namespace

void draw_legend(const Context& context, const Plot& plot, const Area& frame,
                 std::span<const std::vector<plot::Point>> lines, float above, bool with_title) {
    const auto card_in = [&](ImFont* const font, Names names) {
        const WithFont with(font);
        return card_of(context, plot, frame, with_title, names);
    };
    ImFont* font = context.theme.fonts().small;
    Card card = card_in(font, Names::usual);
    if (covers_most(card, frame, 0.35f) && !context.is_saved()) {
        font = context.theme.fonts().tiny;
        card = card_in(font, Names::small);
        // the pointer tells the names
        if (covers_most(card, frame, 0.6f)) card = card_in(font, Names::none);
    }
    if (card.empty()) return;
    above += 1;
    const auto [known, is_first] = context.state.plots.legends.try_emplace(plot.name);
    plot::Corner& corner = known->second;  // one that stands somewhere moves only for more than a crest
    corner = plot::free_corner(lines, frame, card.size, above, corner, is_first ? 0 : context.px(20));
    const WithFont with(font);
    draw_card(context, plot, card, plot::card_in(frame, corner, card.size.width, card.size.height, above));
}

}  // namespace steplab::ui
