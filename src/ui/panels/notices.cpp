#include "ui/panels/panels.hpp"
#include "ui/widgets/cards.hpp"
#include "ui/widgets/widgets.hpp"

namespace steplab::ui {
namespace {

ImVec2 foot_of_scene(const Context& context) {
    const Area& scene = context.layout.scene;
    return {scene.x + 0.5f * scene.width, scene.bottom() - context.px(16)};
}

void draw_refusal(const Context& context) {
    const std::string& message = context.session.wanted.message();
    const Card card(context, "refusal", foot_of_scene(context), {0.5f, 1}, card_width(context, 460), colour::bad);
    if (close_cross(context, "refusal.close")) context.session.wanted.dismiss();
    ImGui::PushTextWrapPos(ImGui::GetContentRegionAvail().x - context.px(6));
    explanation(context, message, colour::text);
    ImGui::PopTextWrapPos();
}

void draw_note(const Context& context, const std::string& text) {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 foot = foot_of_scene(context);
    const ImVec2 padding{context.px(14), context.px(8)};
    const ImVec2 from{std::round(foot.x - 0.5f * size.x - padding.x), foot.y - size.y - 2 * padding.y};
    list.AddRectFilled(from, {from.x + size.x + 2 * padding.x, foot.y}, colour::card, context.px(6));
    list.AddText({from.x + padding.x, from.y + padding.y}, colour::text, text.c_str());
}

}  // namespace

void draw_notices(const Context& context) {
    auto& notice = context.session.notice;
    if (notice && ImGui::GetTime() >= notice->until) notice.reset();
    if (!context.session.wanted.message().empty()) return draw_refusal(context);
    if (notice) draw_note(context, notice->text);
}

}  // namespace steplab::ui
