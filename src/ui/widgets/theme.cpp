#include "ui/widgets/theme.hpp"

#include <cmath>

namespace steplab::ui {
namespace {

ImVec4 vec(ImU32 colour) { return ImGui::ColorConvertU32ToFloat4(colour); }

void set_colours(ImVec4* colours) {
    const struct {
        ImGuiCol which;
        ImU32 value;
    } table[] = {
        {ImGuiCol_Text, colour::text},
        {ImGuiCol_TextDisabled, colour::text_dim},
        {ImGuiCol_WindowBg, colour::panel},
        {ImGuiCol_ChildBg, 0},
        {ImGuiCol_PopupBg, colour::rgb(0x20262e, 250)},
        {ImGuiCol_Border, colour::line},
        {ImGuiCol_FrameBg, colour::control},
        {ImGuiCol_FrameBgHovered, colour::control_hover},
        {ImGuiCol_FrameBgActive, colour::control_active},
        {ImGuiCol_ScrollbarBg, 0},
        {ImGuiCol_ScrollbarGrab, colour::track},
        {ImGuiCol_ScrollbarGrabHovered, colour::control_active},
        {ImGuiCol_ScrollbarGrabActive, colour::control_active},
        {ImGuiCol_CheckMark, colour::on_accent},
        {ImGuiCol_Button, colour::control},
        {ImGuiCol_ButtonHovered, colour::control_hover},
        {ImGuiCol_ButtonActive, colour::control_active},
        {ImGuiCol_Header, colour::control_hover},
        {ImGuiCol_HeaderHovered, colour::control_active},
        {ImGuiCol_HeaderActive, colour::control_active},
        {ImGuiCol_Separator, colour::line},
        {ImGuiCol_TextSelectedBg, colour::rgb(0x4ea1ff, 110)},
        {ImGuiCol_NavHighlight, colour::accent},
        {ImGuiCol_ModalWindowDimBg, colour::rgb(0x000000, 110)},
    };
    for (const auto& entry : table) colours[entry.which] = vec(entry.value);
}

}  // namespace

void Theme::apply(float scale) {
    scale_ = scale;
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    set_colours(style.Colors);
    style.WindowPadding = {14, 12};
    style.FramePadding = {10, 6};
    style.ItemSpacing = {8, 5};
    style.ItemInnerSpacing = {6, 4};
    style.WindowRounding = 0;
    style.ChildRounding = 5;
    style.FrameRounding = 5;
    style.PopupRounding = 6;
    style.ScrollbarRounding = 4;
    style.ScrollbarSize = 9;
    style.GrabRounding = 5;
    style.WindowBorderSize = 0;
    style.PopupBorderSize = 1;
    style.WindowMinSize = {1, 1};
    style.ScaleAllSizes(scale);
    style.AntiAliasedLinesUseTex = true;
    style.CircleTessellationMaxError = 0.15f;
    ImGui::GetStyle() = style;
    fonts_ = load_fonts(*ImGui::GetIO().Fonts, scale, render::find_font_files());
}

float Theme::px(float units) const { return std::round(units * scale_); }

}  // namespace steplab::ui
