#include "ui/widgets/theme.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

ImVec4 vec(ImU32 colour) { return ImGui::ColorConvertU32ToFloat4(colour); }

void set_colours(ImVec4* of_imgui) {
    const struct {
        ImGuiCol which;
        ImU32 value;
    } table[] = {
        {ImGuiCol_Text, colour::text},
        {ImGuiCol_TextDisabled, colour::text_dim},
        {ImGuiCol_WindowBg, colour::panel},
        {ImGuiCol_ChildBg, 0},
        {ImGuiCol_PopupBg, colour::popup},
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
        {ImGuiCol_Header, colour::control},
        {ImGuiCol_HeaderHovered, colour::control_hover},
        {ImGuiCol_HeaderActive, colour::control_active},
        {ImGuiCol_Separator, colour::line},
        {ImGuiCol_TextSelectedBg, colour::selection},
        {ImGuiCol_NavHighlight, colour::accent},
    };
    for (const auto& entry : table) of_imgui[entry.which] = vec(entry.value);
}

}  // namespace

void Theme::apply(float scale) {
    scale_ = scale;
    ImGuiStyle style;
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
    style.ScaleAllSizes(scale);
    style.WindowMinSize = {1, 1};  // ImGui allows no less
    style.AntiAliasedLinesUseTex = true;
    style.CircleTessellationMaxError = 0.15f;
    std::copy_n(ImGui::GetStyle().Colors, ImGuiCol_COUNT, style.Colors);
    ImGui::GetStyle() = style;
    fonts_ = load_fonts(*ImGui::GetIO().Fonts, scale, render::find_font_files());
}

void Theme::set_background(render::Background background) {
    if (background_ == background) return;
    background_ = background;
    use_colours(background);
    ImGui::StyleColorsDark();  // for what the table does not have
    set_colours(ImGui::GetStyle().Colors);
}

float Theme::px(float units) const { return std::round(units * scale_); }

}  // namespace steplab::ui
