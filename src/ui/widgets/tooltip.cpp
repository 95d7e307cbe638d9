#include "core/terms.hpp"
#include "ui/input.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace steplab::ui {
namespace {

constexpr float widest_text = 300;  // units of the layout

ImVec2 padding(const Context& context) { return {context.px(10), context.px(8)}; }

ImVec2 size_of(const Context& context, const std::string& lines) {
    const ImVec2 inside = ImGui::CalcTextSize(lines.c_str());
    return {inside.x + 2 * padding(context).x, inside.y + 2 * padding(context).y};
}

void draw(const Context& context, ImVec2 corner, const std::string& lines) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding(context));
    ImGui::PushStyleColor(ImGuiCol_Border, colour::line);  // not that of a card with an edge of its own
    ImGui::SetNextWindowPos(corner);
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(lines.c_str());
    ImGui::EndTooltip();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

}  // namespace

ImVec2 place_beside(const WidgetRect& item, ImVec2 size, ImVec2 display, float gap, Beside first) {
    const float across = std::max(0.0f, std::min(item.left, display.x - size.x));
    const float down = std::max(0.0f, std::min(item.top, display.y - size.y));
    const ImVec2 below{across, item.bottom + gap}, above{across, item.top - gap - size.y};
    const ImVec2 right{item.right + gap, down}, left{item.left - gap - size.x, down};
    const std::array<ImVec2, 4> places =
        first == Beside::below ? std::array{below, above, right, left} : std::array{right, left, below, above};
    for (const ImVec2& place : places) {
        if (place.x >= 0 && place.y >= 0 && place.x + size.x <= display.x && place.y + size.y <= display.y)
            return place;
    }
    return {across, down};  // no side has room
}

namespace {

void show(const Context& context, const WidgetRect& item, std::string_view text, Beside first) {
    if (text.empty() || ImGui::IsMouseDown(0)) return;
    const WithFont font(context.theme.fonts().small);
    const std::string lines = in_words(text, context.px(widest_text));
    const ImVec2 size = size_of(context, lines);
    const ImVec2 corner = place_beside(item, size, ImGui::GetIO().DisplaySize, context.px(6), first);
    draw(context, corner, lines);
    context.mark("tooltip", {corner.x, corner.y, corner.x + size.x, corner.y + size.y});
}

}  // namespace

void tooltip_beside(const Context& context, const WidgetRect& item, std::string_view text, Beside first) {
    if (ImGui::IsItemHovered()) show(context, item, text, first);
}

void tooltip_in_scene(const Context& context, const WidgetRect& place, std::string_view text) {
    if (context.purpose != Purpose::use || ImGui::GetIO().WantCaptureMouse) return;
    if (ImGui::IsMouseHoveringRect({place.left, place.top}, {place.right, place.bottom}, false))
        show(context, place, text, Beside::below);
}

void tooltip(const Context& context, std::string_view text) {
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    tooltip_beside(context, {from.x, from.y, to.x, to.y}, text);
}

void term_tooltip(const Context& context, std::string_view text, std::string_view shown) {
    if (!ImGui::IsItemHovered()) return;
    tooltip(context, with_explanations(text, shown));
}

void close_if_asked(const Context& context) {
    if (context.purpose == Purpose::use && Input::pressed(Key::escape, false)) ImGui::CloseCurrentPopup();
}

}  // namespace steplab::ui
