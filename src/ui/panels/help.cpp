#include "ui/keys.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/cards.hpp"
#include "ui/widgets/widgets.hpp"

namespace steplab::ui {
namespace {

template <class Rows>
void draw_rows(const Context& context, const Rows& rows, float column) {
    for (const auto& row : rows) {
        ImGui::PushStyleColor(ImGuiCol_Text, colour::accent_hover);
        ImGui::TextUnformatted(row.label.data(), row.label.data() + row.label.size());
        ImGui::PopStyleColor();
        ImGui::SameLine(column);
        explanation(context, row.what, colour::text);
    }
}

}  // namespace

void draw_help(const Context& context) {
    if (!context.state.help_open) return;
    const Display& display = context.display;
    const ImVec2 centre{0.5f * static_cast<float>(display.width), 0.5f * static_cast<float>(display.height)};
    const float width = std::min(context.px(430), static_cast<float>(display.width) - context.px(16));
    const Card card(context, "help", centre, {0.5f, 0.5f}, width, colour::line);
    if (close_cross(context, "help.close")) context.state.help_open = false;
    const WithFont font(context.theme.fonts().small);
    {
        const WithFont strong(context.theme.fonts().strong);
        ImGui::TextUnformatted("Keyboard and mouse");
    }
    draw_rows(context, key_bindings(), context.px(110));
    ImGui::Dummy({0, context.px(4)});
    draw_rows(context, mouse_bindings(), 0.62f * width);
}

}  // namespace steplab::ui
