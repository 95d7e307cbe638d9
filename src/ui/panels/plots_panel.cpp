#include "ui/panels/panels.hpp"
#include "ui/plot/plot.hpp"

#include <fmt/format.h>

#include <cmath>

namespace steplab::ui {
namespace {

/// |E - E0| on a logarithmic axis. With drag the energy changes without any error: the plot is then named so.
Plot energy_plot(const History& history, bool drag) {
    Plot plot{.widget = "energy error", .title = drag ? "Energy change [J]" : "Energy error [J]", .unit = "J"};
    plot.logarithmic = true;
    plot.empty = "no data yet";
    Curve curve{.name = drag ? "change" : "error"};
    for (const Sample& sample : history.whole()) {
        curve.x.push_back(sample.time);
        curve.y.push_back(sample.energy_error);
    }
    plot.curves.push_back(std::move(curve));
    return plot;
}

double part_along(const std::optional<Vec3>& vector, int axis) {
    return vector ? component(*vector, axis) : std::nan("");
}

Plot displacement_plot(const History& history) {
    constexpr std::string_view names[] = {"displacement x [m]", "displacement y [m]", "displacement z [m]"};
    Plot plot{.widget = "displacement", .title = "No particle selected", .unit = "m"};
    plot.empty = "click a particle to plot its displacement";
    if (!history.particle()) return plot;
    const int axis = history.direction();
    plot.title = fmt::format("Particle {}: {}", *history.particle(), names[axis]);
    plot.empty = "no data yet";
    Curve run{.name = "run"};
    Curve exact{.name = "exact", .ink = colour::exact, .dashed = true};
    bool known = false;
    for (const Sample& sample : history.recent()) {
        run.x.push_back(sample.time);
        run.y.push_back(part_along(sample.displacement, axis));
        exact.y.push_back(part_along(sample.exact_displacement, axis));
        known = known || sample.exact_displacement;
    }
    exact.x = run.x;
    plot.curves.push_back(std::move(run));
    if (known) plot.curves.push_back(std::move(exact));
    return plot;
}

}  // namespace

void draw_plots_panel(const Context& context) {
    const Area& area = context.layout.plots;
    if (area.empty()) return;
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colour::backdrop);
    ImGui::Begin("plots", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollWithMouse |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    const float gap = context.px(10);
    const auto count = static_cast<float>(context.layout.plot_count);
    const float width = std::round((area.width - gap * (count + 1)) / count);
    Area place{area.x + gap, area.y + gap, width, area.height - 2 * gap};
    Plot energy = energy_plot(context.state.history, has_drag(context.view.description));
    if (context.session.playback && !context.session.playback->measured) {
        energy.curves.clear();
        energy.empty = "not known: the file does not have a whole scene";
    }
    draw_plot(context, energy, place);
    place.x += width + gap;
    if (context.layout.plot_count > 1) draw_plot(context, displacement_plot(context.state.history), place);
    ImGui::End();
    ImGui::PopStyleColor();
}

}  // namespace steplab::ui
