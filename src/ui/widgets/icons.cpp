#include "ui/widgets/icons.hpp"

#include "ui/widgets/widgets.hpp"

namespace steplab::ui {
namespace {

/// Draws shapes around the centre of the icon, in units of half its size.
struct Pen {
    ImDrawList& list;
    ImVec2 centre;
    float half;
    ImU32 ink;

    ImVec2 at(float x, float y) const { return {centre.x + x * half, centre.y + y * half}; }
    void bar(float left, float right) const { list.AddRectFilled(at(left, -0.8f), at(right, 0.8f), ink, 0.1f * half); }
    void right_triangle(float base, float tip) const {
        list.AddTriangleFilled(at(base, -0.8f), at(tip, 0), at(base, 0.8f), ink);
    }
    void left_triangle(float base, float tip) const {
        list.AddTriangleFilled(at(base, -0.8f), at(base, 0.8f), at(tip, 0), ink);
    }
    void arrows_to_and_fro() const {
        list.AddRectFilled(at(-0.85f, -0.57f), at(0.4f, -0.33f), ink);
        list.AddTriangleFilled(at(0.3f, -0.9f), at(0.95f, -0.45f), at(0.3f, 0), ink);
        list.AddRectFilled(at(-0.4f, 0.33f), at(0.85f, 0.57f), ink);
        list.AddTriangleFilled(at(-0.3f, 0.9f), at(-0.95f, 0.45f), at(-0.3f, 0), ink);
    }
    void lines() const {
        for (const float y : {-0.6f, 0.0f, 0.6f}) {
            list.AddRectFilled(at(-0.85f, y - 0.12f), at(0.85f, y + 0.12f), ink);
        }
    }
    void arrow_into_tray() const {
        list.AddRectFilled(at(-0.12f, -0.9f), at(0.12f, 0), ink);
        list.AddTriangleFilled(at(-0.5f, -0.1f), at(0.5f, -0.1f), at(0, 0.45f), ink);
        list.AddRectFilled(at(-0.8f, 0.65f), at(0.8f, 0.9f), ink);
    }
};

ImU32 fill_colour(ButtonStyle style, bool enabled) {
    const bool hovered = ImGui::IsItemHovered() && enabled;
    if (style == ButtonStyle::accent) return hovered ? colour::accent_hover : colour::accent;
    if (ImGui::IsItemActive() && enabled) return colour::control_active;
    if (hovered) return colour::control_hover;
    return style == ButtonStyle::quiet ? ImU32{0} : ImU32{colour::control};
}

ImU32 ink_colour(ButtonStyle style, bool enabled) {
    if (!enabled) return colour::text_faint;
    if (style == ButtonStyle::accent) return colour::on_accent;
    return style == ButtonStyle::quiet && !ImGui::IsItemHovered() ? colour::text_faint : colour::text;
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 ink) {
    const Pen pen{list, centre, 0.5f * size, ink};
    switch (icon) {
        case Icon::restart:
            pen.bar(-0.85f, -0.55f);
            return pen.left_triangle(0.8f, -0.45f);
        case Icon::step_back:
            pen.bar(0.5f, 0.8f);
            return pen.left_triangle(0.35f, -0.8f);
        case Icon::play:
            return pen.right_triangle(-0.55f, 0.8f);
        case Icon::play_back:
            return pen.left_triangle(0.55f, -0.8f);
        case Icon::loop:
            return pen.arrows_to_and_fro();
        case Icon::pause:
            pen.bar(-0.7f, -0.2f);
            return pen.bar(0.2f, 0.7f);
        case Icon::step_forward:
            pen.bar(-0.8f, -0.5f);
            return pen.right_triangle(-0.35f, 0.8f);
        case Icon::menu:
            return pen.lines();
        case Icon::save:
            return pen.arrow_into_tray();
    }
}

bool icon_button(const Context& context, std::string_view widget, Icon icon, std::string_view help, ButtonStyle style,
                 bool enabled) {
    const WithId id(widget);
    const float side = ImGui::GetFrameHeight();
    const bool clicked = ImGui::InvisibleButton("icon", {side + context.px(4), side}) && enabled;
    context.mark(widget);
    tooltip(context, help);
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, to, fill_colour(enabled ? style : ButtonStyle::plain, enabled),
                       ImGui::GetStyle().FrameRounding);
    const ImU32 ink = ink_colour(style, enabled);
    draw_icon(list, icon, {0.5f * (from.x + to.x), 0.5f * (from.y + to.y)}, context.px(13), ink);
    return clicked;
}

}  // namespace steplab::ui
