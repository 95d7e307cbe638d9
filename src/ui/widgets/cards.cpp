#include "ui/widgets/cards.hpp"

#include "ui/widgets/widgets.hpp"

#include <imgui_internal.h>

#include <algorithm>

namespace steplab::ui {

namespace {

/// What has no room above or below its anchor, by its height in the last frame, covers what lies there rather than
/// leave the display.
void place(const Context& context, const char* name, ImVec2 anchor, ImVec2 pivot, float margin) {
    const ImGuiWindow* const before = ImGui::FindWindowByName(name);
    const float height = before ? before->Size.y : 0, top = anchor.y - pivot.y * height;
    const float lowest = static_cast<float>(context.display.height) - margin - height;
    const float held = std::max(margin, std::min(top, lowest));
    if (held != top) anchor.y = held, pivot.y = 0;
    ImGui::SetNextWindowPos(anchor, ImGuiCond_Always, pivot);
}

}  // namespace

Card::Card(const Context& context, const char* name, ImVec2 anchor, ImVec2 pivot, float width, ImU32 edge) {
    const float margin = context.px(8);
    place(context, name, anchor, pivot, margin);
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, static_cast<float>(context.display.height) - 2 * margin});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, context.px(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(1.0f, context.px(1)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(16), context.px(14)});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colour::window);
    ImGui::PushStyleColor(ImGuiCol_Border, edge);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    context.mark(name,
                 {ImGui::GetWindowPos().x, ImGui::GetWindowPos().y, ImGui::GetWindowPos().x + ImGui::GetWindowSize().x,
                  ImGui::GetWindowPos().y + ImGui::GetWindowSize().y});
}

Card::~Card() {
    ImGui::End();
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(3);
}

bool close_cross(const Context& context, std::string_view widget) {
    const ImVec2 cursor = ImGui::GetCursorPos();
    ImGui::SetCursorPos({ImGui::GetWindowContentRegionMax().x - context.px(12), ImGui::GetScrollY() + context.px(8)});
    const bool clicked = cross_button(context, widget);
    ImGui::SetCursorPos(cursor);
    return clicked;
}

float card_width(const Context& context, float units) {
    return std::min(context.px(units), context.layout.scene.width - context.px(16));
}

}  // namespace steplab::ui
