#include "core/terms.hpp"
#include "ui/panels/panels.hpp"
#include "ui/plot/costs_plot.hpp"
#include "ui/plot/draw_plot.hpp"
#include "ui/plot/move_axes.hpp"
#include "ui/plot/plots.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

constexpr float header = 26;  // height of a plot's own line of controls, in units of the layout

/// Samples are taken once there are plots to show them, and on while these are hidden: what is missing then would be
/// missing from the curves later.
void ask_for_samples(const Context& context) {
    if (context.purpose != Purpose::use || context.layout.plots.empty()) return;
    if (std::exchange(context.state.plots.sampled, true) != true) context.events.send(event::ShowSamples{true});
}

/// How many of the chosen plots have room.
std::size_t shown_plots(const Context& context) {
    return std::min(context.state.plots.shown.size(), static_cast<std::size_t>(context.layout.plot_count));
}

/// Costs are scanned once their plot is shown, and on while it is hidden, until it is closed.
void ask_for_costs(const Context& context) {
    if (context.purpose != Purpose::use) return;
    PlotsState& plots = context.state.plots;
    const auto chosen = std::find_if(plots.shown.begin(), plots.shown.end(),
                                     [](const PlotChoice& choice) { return shows_costs(choice.kind); });
    const auto number = static_cast<std::size_t>(chosen - plots.shown.begin());
    const bool seen = !context.layout.plots.empty() && number < shown_plots(context);
    const bool wanted = !context.session.playback && chosen != plots.shown.end() && (seen || plots.scanned == true);
    if (std::exchange(plots.scanned, wanted).value_or(false) != wanted) context.events.send(event::ShowCosts{wanted});
}

/// A click on a point of the diagram adds its run.
void use_costs(const Context& context, PlotKind kind, const plot::Layout& layout) {
    if (context.purpose != Purpose::use || !ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem))
        return;
    const CostPoint* const point = cost_point_at(context, kind, layout);
    if (!point) return;
    const float x = layout.axes.across.pixel(point->*cost_of(kind)), y = layout.axes.up.pixel(point->error);
    ImGui::GetWindowDrawList()->AddCircle({x, y}, context.px(6), colour::accent, 0, context.px(1.6f));
    tooltip_beside(context, {x, layout.frame.y, x, layout.frame.bottom()}, text_of(*point, context));
    const ImGuiIO& io = ImGui::GetIO();
    const bool dragged = io.MouseDragMaxDistanceSqr[0] > io.MouseDragThreshold * io.MouseDragThreshold;
    if (ImGui::IsMouseReleased(0) && !dragged) context.events.send(event::AddRun{run_of(*point, context)});
}

std::vector<ComboItem> made_kind_items() {
    std::vector<ComboItem> items;
    items.reserve(plot_kinds.size());
    for (const PlotKindInfo& info : plot_kinds)
        items.push_back({.id = info.id, .name = info.name, .tooltip = with_explanations(info.what, info.name)});
    return items;
}

/// The same at all times, so they are made once.
const std::vector<ComboItem>& kind_items() {
    static const std::vector<ComboItem> items = made_kind_items();
    return items;
}

/// Another kind in place of a plot; one that is shown elsewhere changes places with it.
void choose(PlotsState& plots, std::size_t number, PlotKind kind) {
    const auto found = std::find_if(plots.shown.begin(), plots.shown.end(),
                                    [kind](const PlotChoice& choice) { return choice.kind == kind; });
    if (found != plots.shown.end()) {
        std::swap(*found, plots.shown[number]);
    } else {
        plots.shown[number] = default_choice(kind);
    }
}

/// Of the button of the scale, whose word is a short one in narrow plots.
bool is_narrow(const Context& context, const Area& area) { return area.width < context.px(280); }
float scale_width(const Context& context, const Area& area) { return context.px(is_narrow(context, area) ? 36 : 56); }

/// Of the box that names the kind: what the other controls leave.
float kind_width(const Context& context, const Area& area) {
    const bool adds = context.state.plots.shown.size() < static_cast<std::size_t>(context.layout.plot_count);
    const float others = scale_width(context, area) + context.px(adds ? 120 : 92);
    return std::clamp(area.width - others, context.px(60), context.px(172));
}

void draw_kind(const Context& context, std::size_t number, const Area& area) {
    const std::vector<ComboItem>& items = kind_items();
    auto chosen = static_cast<std::size_t>(context.state.plots.shown[number].kind);
    if (combo(context, "plot " + std::to_string(number + 1), items, chosen, kind_width(context, area)))
        choose(context.state.plots, number, plot_kinds[chosen].kind);
}

/// Of one axis: linear, logarithmic, or logarithmic on both sides of 0. A click goes on to the next one, from which a
/// part that is shown has to begin again.
void draw_scale(const Context& context, const std::string& widget, plot::Scale& scale, std::optional<Range>& shown,
                const Area& area) {
    const std::array<const char*, 3> names{is_narrow(context, area) ? "lin" : "linear", "log", "\u00b1log"};
    const auto chosen = static_cast<std::size_t>(scale);
    if (!text_button(context, widget, names[chosen], false, scale_width(context, area))) return;
    scale = static_cast<plot::Scale>((chosen + 1) % names.size());
    shown.reset();
}

void draw_scale_up(const Context& context, PlotChoice& choice, const Area& area) {
    draw_scale(context, std::string(info_of(choice.kind).id) + ".scale", choice.scale, choice.up, area);
    tooltip(context, "the axis up: linear, logarithmic (of values above 0), or logarithmic on both sides of 0");
}

/// Beside the name of the axis, at the right.
void draw_scale_across(const Context& context, PlotChoice& choice, const Area& area, const Area& frame) {
    const WithFont font(context.theme.fonts().small);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, context.px(1)});
    const float height = ImGui::GetFrameHeight();
    ImGui::SetCursorScreenPos(
        {frame.right() - scale_width(context, area), area.bottom() - context.px(12) - 0.5f * height});
    draw_scale(context, std::string(info_of(choice.kind).id) + ".across", choice.across_scale, choice.across, area);
    ImGui::PopStyleVar();
    tooltip(context, "the axis across: linear, logarithmic (of values above 0), or logarithmic on both sides of 0");
}

/// The first kind that is not shown yet.
void add_plot(PlotsState& plots) {
    for (const PlotKindInfo& info : plot_kinds) {
        const auto is_it = [&](const PlotChoice& choice) { return choice.kind == info.kind; };
        if (std::none_of(plots.shown.begin(), plots.shown.end(), is_it))
            return plots.shown.push_back(default_choice(info.kind));
    }
}

/// What adds a plot, or takes one away, at the right of the line.
void draw_count(const Context& context, std::size_t number, const Area& area) {
    PlotsState& plots = context.state.plots;
    const bool last = number + 1 == shown_plots(context);
    const bool room = plots.shown.size() < static_cast<std::size_t>(context.layout.plot_count);
    float right = area.right() - context.px(40);
    const std::string id(info_of(plots.shown[number].kind).id);
    if (plots.shown.size() > 1) {
        right -= context.px(24);
        ImGui::SetCursorScreenPos({right, area.y + context.px(5)});
        if (cross_button(context, id + ".close")) plots.shown.erase(plots.shown.begin() + static_cast<long>(number));
    }
    if (!last || !room || plots.shown.size() >= PlotsState::most) return;
    ImGui::SetCursorScreenPos({right - context.px(30), area.y + context.px(3)});
    if (text_button(context, "plots.add", "+", false, context.px(26))) add_plot(plots);
    tooltip(context, "another plot");
}

/// Where what the axis up means stands in the line of controls.
float title_from(const Context& context, const Area& area) {
    return area.x + kind_width(context, area) + scale_width(context, area) + context.px(8 + 6 + 10);
}

bool has_room_for_title(const Context& context, const plot::Plot& plot, const Area& area) {
    const WithFont font(context.theme.fonts().small);
    const float room = area.right() - context.px(100) - title_from(context, area);
    return context.is_saved() || ImGui::CalcTextSize(plot.title.c_str()).x <= room;
}

/// The controls of a plot, and what its axis up means where there is room beside them; in a picture that is saved the
/// latter alone.
void draw_header(const Context& context, const plot::Plot& plot, std::size_t number, const Area& area) {
    const float y = area.y + context.px(0.5f * header + 3);
    if (context.is_saved()) {
        const WithFont font(context.theme.fonts().heading);
        return text_left(area.x + context.px(14), y, plot.title, colour::text);
    }
    ImGui::SetCursorScreenPos({area.x + context.px(8), area.y + context.px(3)});
    draw_kind(context, number, area);
    ImGui::SameLine(0, context.px(6));
    draw_scale_up(context, context.state.plots.shown[number], area);
    const WithFont font(context.theme.fonts().small);
    if (has_room_for_title(context, plot, area)) text_left(title_from(context, area), y, plot.title, colour::text_dim);
    draw_count(context, number, area);
}

void draw_chosen(const Context& context, std::size_t number, const Area& area) {
    const plot::Plot plot = plot_of(context, context.state.plots.shown[number]);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({area.x, area.y}, {area.right(), area.bottom()}, colour::panel, context.px(5));
    list.AddRect({area.x, area.y}, {area.right(), area.bottom()}, colour::line, context.px(5));
    draw_plot(context, plot, area, !has_room_for_title(context, plot, area));
    const plot::Layout layout = plot_layout(context.theme, plot, area);
    move_axes(context, plot, layout, area, context.state.plots.shown[number]);
    if (const PlotKind kind = context.state.plots.shown[number].kind; shows_costs(kind))
        use_costs(context, kind, layout);
    draw_header(context, plot, number, area);
    if (!context.is_saved()) draw_scale_across(context, context.state.plots.shown[number], area, layout.frame);
}

}  // namespace

void draw_plots_panel(const Context& context) {
    ask_for_samples(context);
    ask_for_costs(context);
    const Area& area = context.layout.plots;
    if (area.empty()) return;
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colour::backdrop);
    ImGui::Begin("plots", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBringToFrontOnFocus);
    const float gap = context.px(10);
    const std::size_t shown = shown_plots(context);
    const auto count = static_cast<float>(shown);
    const float width = std::round((area.width - gap * (count + 1)) / count);
    Area place{area.x + gap, area.y + gap, width, area.height - 2 * gap};
    for (std::size_t number = 0; number < shown && number < context.state.plots.shown.size(); ++number) {
        draw_chosen(context, number, place);
        place.x += width + gap;
    }
    ImGui::End();
    ImGui::PopStyleColor();
}

}  // namespace steplab::ui
