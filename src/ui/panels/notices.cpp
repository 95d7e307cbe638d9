#include "ui/panels/panels.hpp"
#include "ui/widgets/cards.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>

namespace steplab::ui {
namespace {

ImVec2 foot_of_scene(const Context& context) {
    const Area& scene = context.layout.scene;
    return {scene.x + 0.5f * scene.width, scene.bottom() - context.px(16)};
}

void draw_refusal(const Context& context) {
    const std::string& message = context.state.wanted.message();
    const Card card(context, "refusal", foot_of_scene(context), {0.5f, 1}, card_width(context, 460), colour::bad);
    if (close_cross(context, "refusal.close")) context.state.wanted.dismiss();
    ImGui::PushTextWrapPos(ImGui::GetContentRegionAvail().x - context.px(6));
    explanation(context, message, colour::text);
    context.mark("refusal.text");  // where that is another one, the card has its size a frame later
    ImGui::PopTextWrapPos();
}

/// As wide as its text, or wrapped where the scene is narrower.
float note_width(const Context& context, const std::string& text) {
    return std::min(ImGui::CalcTextSize(text.c_str()).x + 2 * context.px(17), card_width(context, 900));
}

/// A click on the text, which is the last item, copies what it names; it stays as long as the pointer is over it.
void offer_copy(const Context& context, Notice& notice) {
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    const ImVec2 end = ImGui::GetCursorPos();
    ImGui::SetCursorScreenPos(from);
    const bool clicked = ImGui::InvisibleButton("copy", {to.x - from.x, to.y - from.y});
    const bool hovered = ImGui::IsItemHovered();
    const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    tooltip_beside(context, {corner.x, corner.y, corner.x + size.x, corner.y + size.y}, "click to copy the path");
    ImGui::SetCursorPos(end);
    if (!hovered) return;
    notice.until = std::max(notice.until, ImGui::GetTime() + 1);
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (!clicked) return;
    context.request({.kind = Request::Kind::copy_text, .text = notice.copy});
    notice = {"copied " + notice.copy, ImGui::GetTime() + 2.5};
}

void draw_note(const Context& context, Notice& notice) {
    const Card card(context, "notice", foot_of_scene(context), {0.5f, 1}, note_width(context, notice.text),
                    colour::line);
    ImGui::TextWrapped("%s", notice.text.c_str());
    if (!notice.copy.empty()) offer_copy(context, notice);
}

}  // namespace

void draw_notices(const Context& context) {
    auto& notice = context.state.notice;
    if (notice && ImGui::GetTime() >= notice->until) notice.reset();
    if (!context.state.wanted.message().empty()) return draw_refusal(context);
    if (notice && !context.is_saved()) draw_note(context, *notice);
}

}  // namespace steplab::ui
