#include "core/number_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

namespace steplab::ui {
namespace {

constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// "420", "1.9e6".
std::string frequency(double value) { return value < 1000 ? fmt::format("{:.0f}", value) : rounded_text(value); }

/// "1.9e6 steps/s · 7.6e6 force evaluations/s · 4.1 ms per frame"; values that are not known are left out.
std::string footer_text(const RunView& view, const Measured& measured) {
    std::string text;
    const auto add = [&](const std::string& part) { text.append(text.empty() ? "" : " · ").append(part); };
    if (view.steps_per_second.value_or(0) > 0) add(frequency(*view.steps_per_second) + " steps/s");
    if (view.evaluations_per_second.value_or(0) > 0)
        add(frequency(*view.evaluations_per_second) + " force evaluations/s");
    if (measured.frame_seconds) add(setting_text(1e3 * *measured.frame_seconds, 2) + " ms per frame");
    return text;
}

void draw_sections(const Context& context) {
    draw_scene_panel(context);
    draw_method_panel(context);
    draw_step_panel(context);
    draw_show_panel(context);
    draw_energy_panel(context);
}

}  // namespace

void draw_side_panel(const Context& context) {
    const Area& area = context.layout.panel;
    if (area.empty()) return;
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin("side panel", nullptr, fixed_window);
    const float footer = context.px(28);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(14), context.px(6)});
    ImGui::BeginChild("sections", {0, area.height - footer}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    draw_sections(context);
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
    draw_footer(context);
    ImGui::GetWindowDrawList()->AddLine({area.right() - 1, area.y}, {area.right() - 1, area.bottom()}, colour::line);
    ImGui::End();
}

void draw_footer(const Context& context) {
    const Area& area = context.layout.panel;
    const WithFont font(context.theme.fonts().tiny);
    text_left(area.x + context.px(14), area.bottom() - context.px(15), footer_text(context.view, context.measured),
              colour::text_faint);
}

}  // namespace steplab::ui
