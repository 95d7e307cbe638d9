#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace steplab::ui {
namespace {

/// An item of the open menu; true if it was clicked.
bool draw_item(const Context& context, std::string_view widget, const ComboItem& item, bool selected) {
    const WithId id(item.id);
    const float height = ImGui::GetTextLineHeight() + context.px(8);
    const bool possible = item.refusal.empty();
    const ImGuiSelectableFlags flags = possible ? 0 : ImGuiSelectableFlags_DontClosePopups;
    const bool clicked = ImGui::Selectable("##item", selected, flags, {0, height}) && possible;
    context.mark(std::string(widget) + "/" + std::string(item.id));
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    const ImVec2 menu = ImGui::GetWindowPos();
    tooltip_beside(context, {menu.x, from.y, menu.x + ImGui::GetWindowSize().x, to.y},
                   possible ? item.tooltip : item.refusal, Beside::right);
    const float y = 0.5f * (from.y + to.y);
    const ImU32 ink = !possible ? colour::text_faint : selected ? colour::accent_hover : colour::text;
    text_left(from.x + context.px(10), y, item.name, ink);
    const WithFont font(context.theme.fonts().small);
    text_right(to.x - context.px(10), y, item.remark, possible ? colour::text_dim : colour::text_faint);
    return clicked;
}

/// The heading of a group of items.
void draw_group(const Context& context, std::string_view widget, std::string_view group) {
    const WithFont font(context.theme.fonts().small);
    ImGui::Dummy({0, ImGui::GetTextLineHeight() + context.px(6)});
    context.mark(std::string(widget) + "/[" + std::string(group) + "]");
    const ImVec2 from = ImGui::GetItemRectMin();
    text_left(from.x + context.px(4), 0.5f * (from.y + ImGui::GetItemRectMax().y) + context.px(2), group,
              colour::text_faint);
}

struct Box {
    ImVec2 from;
    ImVec2 to;
};

/// The name of the chosen item and the arrow, over the box that ImGui has drawn.
void draw_box(const Context& context, ImDrawList& list, const Box& box, std::string_view name) {
    const float y = 0.5f * (box.from.y + box.to.y);
    const float x = box.to.x - context.px(16);
    const float half = context.px(4);
    list.AddTriangleFilled({x - half, y - 0.5f * half}, {x + half, y - 0.5f * half}, {x, y + 0.8f * half},
                           colour::text_dim);
    const ImVec4 room{box.from.x, box.from.y, x - 1.5f * half, box.to.y};
    const float from = box.from.x + context.px(room.z - room.x < context.px(100) ? 7 : 11);
    ImFont* font = context.theme.fonts().strong;
    if (from + font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, name.data(), name.data() + name.size()).x > room.z)
        font = context.theme.fonts().small;
    const WithFont used(font);
    const std::string text = shortened(name, room.z - from);
    list.AddText(font, font->FontSize, {from, std::round(y - 0.5f * font->FontSize)}, colour::text, text.c_str(),
                 nullptr, 0, &room);
}

/// Width of the widest item, including the gap between name and remark.
float list_width(const Context& context, std::span<const ComboItem> items) {
    float width = 0;
    for (const ComboItem& item : items) {
        const float name = ImGui::CalcTextSize(item.name.data(), item.name.data() + item.name.size()).x;
        width = std::max(width, name + ImGui::CalcTextSize(item.remark.c_str()).x);
    }
    return width + context.px(60);
}

}  // namespace

std::optional<std::size_t> item_list(const Context& context, std::string_view widget, std::span<const ComboItem> items,
                                     std::optional<std::size_t> shown) {
    std::optional<std::size_t> chosen;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, context.px(1)});
    std::string_view group;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (items[i].group != group) draw_group(context, widget, group = items[i].group);
        if (draw_item(context, widget, items[i], i == shown)) chosen = i;
    }
    ImGui::PopStyleVar();
    return chosen;
}

void size_item_list(const Context& context, std::span<const ComboItem> items, float least_width) {
    ImGui::SetNextWindowSizeConstraints({std::max(least_width, list_width(context, items)), 0},
                                        {context.px(420), 0.95f * static_cast<float>(context.display.height)});
}

bool choice_box(const Context& context, std::string_view widget, std::string_view name, float width) {
    const WithId id(widget);
    const bool clicked = ImGui::InvisibleButton("box", {width, ImGui::GetFrameHeight()});
    context.mark(widget);
    const Box box{ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(box.from, box.to, ImGui::IsItemHovered() ? colour::control_hover : colour::control,
                       ImGui::GetStyle().FrameRounding);
    draw_box(context, list, box, name);
    return clicked;
}

bool combo(const Context& context, std::string_view widget, std::span<const ComboItem> items, std::size_t& chosen,
           float width) {
    const WithId id(widget);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const Box box{corner, {corner.x + width, corner.y + ImGui::GetFrameHeight()}};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::SetNextItemWidth(width);
    size_item_list(context, items, width);
    const bool open = ImGui::BeginCombo("##combo", "", ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLargest);
    context.mark(widget, {box.from.x, box.from.y, box.to.x, box.to.y});
    if (!open) context.note_focus(widget);
    draw_box(context, list, box, items[chosen].name);
    if (!open) return false;
    close_if_asked(context);
    const std::size_t shown = chosen;
    chosen = item_list(context, widget, items, shown).value_or(shown);
    ImGui::EndCombo();
    return chosen != shown;
}

}  // namespace steplab::ui
