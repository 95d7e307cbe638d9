#include "ui/keys.hpp"
#include "ui/panels/panels.hpp"
#include "ui/steering.hpp"
#include "ui/widgets/cards.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <string>

namespace steplab::ui {
namespace {

// In units of the layout. Gestures have longer names than keys.
constexpr float keys_width = 400, key_name = 94;
constexpr float gestures_width = 446, gesture_name = 196;
constexpr float between_columns = 24, beside_columns = 48;

/// Where rows begin, and how wide they and their names are, in pixels.
struct Column {
    ImVec2 corner;
    float width, name;
};

template <class Rows>
void draw_rows(const Context& context, const Rows& rows, const Column& column) {
    const float gap = context.px(8);
    ImGui::SetCursorPosY(column.corner.y);
    for (const auto& row : rows) {
        ImGui::SetCursorPosX(column.corner.x);
        ImGui::PushStyleColor(ImGuiCol_Text, colour::accent_hover);
        ImGui::TextUnformatted(in_words(row.label, column.name - gap).c_str());
        ImGui::PopStyleColor();
        ImGui::SameLine(column.corner.x + column.name);
        ImGui::TextUnformatted(in_words(row.what, column.width - column.name).c_str());
        context.mark("help/" + std::string(row.label));
    }
}

/// Next to each other where the window is wide enough.
void draw_columns(const Context& context, bool wide) {
    const ImVec2 corner = ImGui::GetCursorPos();
    const float all = ImGui::GetContentRegionAvail().x;
    draw_rows(context, key_bindings(), {corner, wide ? context.px(keys_width) : all, context.px(key_name)});
    if (wide) {
        const float left = corner.x + context.px(keys_width + between_columns);
        draw_rows(context, mouse_bindings(), {{left, corner.y}, context.px(gestures_width), context.px(gesture_name)});
    } else {
        ImGui::Dummy({0, context.px(4)});
        draw_rows(context, mouse_bindings(),
                  {ImGui::GetCursorPos(), all, std::min(context.px(gesture_name), 0.5f * all)});
    }
}

}  // namespace

void draw_help(const Context& context) {
    if (!context.state.help_open) return;
    const Display& display = context.display;
    const ImVec2 centre{0.5f * static_cast<float>(display.width), 0.5f * static_cast<float>(display.height)};
    const float room = static_cast<float>(display.width) - context.px(16);
    const float both = context.px(keys_width + between_columns + gestures_width + beside_columns);
    const bool wide = both <= room;
    const Card card(context, "help", centre, {0.5f, 0.5f}, wide ? both : std::min(context.px(430), room), colour::line);
    if (close_cross(context, "help.close")) context.state.help_open = false;
    {
        const WithFont strong(context.theme.fonts().strong);
        ImGui::TextUnformatted("Keyboard and mouse");
    }
    const WithFont font(context.theme.fonts().small);
    draw_columns(context, wide);
    scroll_by_keys(context, "help", true);
}

}  // namespace steplab::ui
