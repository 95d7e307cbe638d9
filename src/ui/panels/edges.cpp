// The edges of panel and plots: a drag makes them larger or smaller, a double click gives them their usual size.
#include "ui/panels/panels.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>

namespace steplab::ui {
namespace {

/// A strip that the pointer can take hold of. True while it is dragged; `reset` after a double click.
struct Edge {
    bool dragged = false;
    bool reset = false;
};

Edge draw_edge(const Context& context, const char* name, const Area& area, std::string_view help) {
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImU32{0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::InvisibleButton("edge", {area.width, area.height});
    context.mark(name);
    const bool active = ImGui::IsItemActive();
    const Edge edge{active && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0),
                    ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)};
    if (active || ImGui::IsItemHovered())
        ImGui::GetWindowDrawList()->AddRectFilled({area.x, area.y}, {area.right(), area.bottom()}, colour::accent,
                                                  context.px(2));
    if (!active) tooltip(context, help);
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    return edge;
}

void draw_panel_edge(const Context& context) {
    const Area& panel = context.layout.panel;
    const float width = context.px(4);
    const Edge edge = draw_edge(context, "panel.edge", {panel.right() - 0.5f * width, panel.y, width, panel.height},
                                "drag: width of the panel; double click: the usual one");
    double& wanted = context.state.sizes.panel_width;
    if (edge.dragged)
        wanted = std::clamp(static_cast<double>(ImGui::GetIO().MousePos.x / context.theme.scale()),
                            PanelSizes::least_width, PanelSizes::most_width);
    if (edge.reset) wanted = PanelSizes::usual_width;
}

void draw_plots_edge(const Context& context) {
    const Area& plots = context.layout.plots;
    const Edge edge = draw_edge(context, "plots.edge", {plots.x, plots.y, plots.width, context.px(5)},
                                "drag: height of the plots; double click: the usual one");
    const float height = (plots.bottom() - ImGui::GetIO().MousePos.y) / context.theme.scale();
    auto& wanted = context.state.sizes.plots_height;
    if (edge.dragged)
        wanted = std::clamp(static_cast<double>(height), PanelSizes::least_height, PanelSizes::most_height);
    if (edge.reset) wanted.reset();
}

}  // namespace

void draw_edges(const Context& context) {
    if (!context.layout.panel.empty()) draw_panel_edge(context);
    if (!context.layout.plots.empty() && !context.layout.plots_in_panel) draw_plots_edge(context);
}

}  // namespace steplab::ui
