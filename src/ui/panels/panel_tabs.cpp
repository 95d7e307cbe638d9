// The tabs of the side panel, in a window too low for all of its sections.

#include "ui/panels/panels.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::ui {
namespace {

struct Tab {
    PanelTab tab;
    std::string_view name;
    std::string_view what;
};
constexpr Tab tabs[] = {
    {PanelTab::scene, "Scene", "what moves, and its parameters"},
    {PanelTab::runs, "Runs", "the runs and their errors"},
    {PanelTab::method, "Method", "method, time step and the verdict on it"},
    {PanelTab::display, "Display", "what is drawn, and how"},
    {PanelTab::state, "State", "energy, momentum, and what is done to the selected particles"},
    {PanelTab::plot, "Plot", "a plot, as the window has no room for plots below the scene"},
};

bool has_content(const Context& context, PanelTab tab) {
    if (tab == PanelTab::runs) return !context.session.followers.empty();
    if (tab == PanelTab::plot) return context.layout.plots.empty() || context.layout.plots_in_panel;
    const auto all = sections_of(context);
    return std::any_of(all.begin(), all.end(), [&](const Section& section) { return section.tab == tab; });
}

std::vector<Tab> tabs_of(const Context& context) {
    std::vector<Tab> shown;
    for (const Tab& tab : tabs) {
        if (has_content(context, tab.tab)) shown.push_back(tab);
    }
    return shown;
}

float width_of(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

/// The name of a tab, underlined if it is the chosen one.
void draw_tab(const Context& context, const Tab& tab, float width) {
    const std::string widget = "tab/" + std::string(tab.name);
    const WithId id(widget);
    PanelTab& chosen = context.state.tab;
    if (ImGui::InvisibleButton("tab", {width, context.layout.panel_tabs.height})) chosen = tab.tab;
    context.mark(widget);
    tooltip(context, tab.what);
    draw_tab_name(context, tab.name, chosen == tab.tab);
}

/// Next to each other, with equal margins.
void draw_row(const Context& context, const std::vector<Tab>& shown) {
    const WithFont font(context.theme.fonts().small);
    float used = 0;
    for (const Tab& tab : shown) used += width_of(tab.name);
    const float room = context.layout.panel_tabs.width - 2 * context.px(6);
    const float margin = std::max(0.0f, room - used) / static_cast<float>(shown.size());
    for (const Tab& tab : shown) {
        draw_tab(context, tab, width_of(tab.name) + margin);
        ImGui::SameLine(0, 0);
    }
}

}  // namespace

void draw_panel_tabs(const Context& context) {
    const Area& area = context.layout.panel_tabs;
    if (area.empty()) return;
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(6), 0});
    ImGui::Begin("panel tabs", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    const std::vector<Tab> shown = tabs_of(context);
    const bool there =
        std::any_of(shown.begin(), shown.end(), [&](const Tab& tab) { return tab.tab == context.state.tab; });
    if (!there) context.state.tab = shown.front().tab;
    draw_row(context, shown);
    ImGui::GetWindowDrawList()->AddLine({area.x, area.bottom() - 1}, {area.right(), area.bottom() - 1}, colour::line);
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace steplab::ui
