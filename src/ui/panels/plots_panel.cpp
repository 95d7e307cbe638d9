#include "core/terms.hpp"
#include "session/run_name.hpp"
#include "ui/panels/panels.hpp"
#include "ui/plot/costs_plot.hpp"
#include "ui/plot/draw_plot.hpp"
#include "ui/plot/move_axes.hpp"
#include "ui/plot/plot_places.hpp"
#include "ui/plot/plots.hpp"
#include "ui/steering.hpp"
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

PlotPlaces places_of(const Context& context) {
    if (context.layout.plots.empty()) return {};
    return plot_places(context.layout.plots, context.state.plots.shown.size(),
                       static_cast<std::size_t>(context.layout.plot_count), context.state.plots.first,
                       context.theme.scale());
}

/// Costs are scanned once their plot is shown, and on while it is hidden, until it is closed.
void ask_for_costs(const Context& context, const PlotPlaces& places) {
    if (context.purpose != Purpose::use) return;
    PlotsState& plots = context.state.plots;
    const auto chosen = std::find_if(plots.shown.begin(), plots.shown.end(),
                                     [](const PlotChoice& choice) { return shows_costs(choice.kind); });
    const auto number = static_cast<std::size_t>(chosen - plots.shown.begin());
    const bool seen = number >= places.first && number < places.first + places.plots.size();
    const bool wanted = !context.session.playback && chosen != plots.shown.end() && (seen || plots.scanned == true);
    if (std::exchange(plots.scanned, wanted).value_or(false) != wanted) context.events.send(event::ShowCosts{wanted});
}

void draw_pointed_cost(const Context& context, const CostPoint& point, PlotKind kind, const plot::Layout& layout) {
    const float x = layout.axes.across.pixel(point.*cost_of(kind)), y = layout.axes.up.pixel(point.error);
    ImGui::GetWindowDrawList()->AddCircle({x, y}, context.px(6), colour::accent, 0, context.px(1.6f));
    tooltip_beside(context, {x, layout.frame.y, x, layout.frame.bottom()}, text_of(point, context));
}

/// The keyboard goes from point to point as from widget to widget.
void steer_costs(const Context& context, PlotKind kind, const plot::Layout& layout) {
    if (!context.session.costs || !is_steered(context, "plots")) return;
    const float radius = context.px(5);
    const std::vector<CostPoint>& costs = context.session.costs->points;
    for (const CostPoint& point : costs) {
        const float x = layout.axes.across.pixel(point.*cost_of(kind)), y = layout.axes.up.pixel(point.error);
        if (!layout.frame.contains(x, y)) continue;
        const std::string widget =
            std::string(info_of(kind).id) + ".point/" + run_name(run_of(point, context), context.view.description);
        const WithId id(widget + std::to_string(&point - costs.data()));  // names may be the same
        ImGui::SetCursorScreenPos({x - radius, y - radius});
        if (ImGui::InvisibleButton("point", {2 * radius, 2 * radius}))
            context.events.send(event::AddRun{run_of(point, context)});
        context.mark(widget);
        if (ImGui::IsItemFocused()) draw_pointed_cost(context, point, kind, layout);
    }
}

/// A click on a point of the diagram adds its run.
void use_costs(const Context& context, PlotKind kind, const plot::Layout& layout) {
    if (context.purpose != Purpose::use) return;
    steer_costs(context, kind, layout);
    if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem)) return;
    const CostPoint* const point = cost_point_at(context, kind, layout);
    if (!point) return;
    draw_pointed_cost(context, *point, kind, layout);
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

/// A plot that is drawn.
struct Slot {
    std::size_t number = 0;  ///< among the chosen ones
    Area area;
    bool adds = false;  ///< it has what adds another plot

    PlotChoice& choice(const Context& context) const { return context.state.plots.shown[number]; }
    std::string id(const Context& context) const { return std::string(info_of(choice(context).kind).id); }
    std::string combo() const { return "plot " + std::to_string(number + 1); }
};

/// True if the keyboard is at one of its controls.
bool is_steered(const Context& context, const Slot& slot) {
    const std::string& focused = context.state.focused;
    return is_steered(context, "plots") && (focused == slot.combo() || focused.starts_with(slot.id(context) + "."));
}

/// Of the box that names the kind: what the other controls leave.
float kind_width(const Context& context, const Slot& slot) {
    const float others = scale_width(context, slot.area) + context.px(slot.adds ? 120 : 92);
    return std::clamp(slot.area.width - others, context.px(60), context.px(172));
}

void draw_kind(const Context& context, const Slot& slot) {
    const std::vector<ComboItem>& items = kind_items();
    auto chosen = static_cast<std::size_t>(slot.choice(context).kind);
    if (combo(context, slot.combo(), items, chosen, kind_width(context, slot)))
        choose(context.state.plots, slot.number, plot_kinds[chosen].kind);
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
        if (std::any_of(plots.shown.begin(), plots.shown.end(), is_it)) continue;
        plots.first = plots.shown.size();
        return plots.shown.push_back(default_choice(info.kind));
    }
}

/// What adds a plot, or takes one away, at the right of the line.
void draw_count(const Context& context, const Slot& slot) {
    PlotsState& plots = context.state.plots;
    const float right = slot.area.right() - context.px(64);  // "+" stays where it is when there is a second plot
    const std::string id = slot.id(context);
    if (plots.shown.size() > 1) {
        ImGui::SetCursorScreenPos({right, slot.area.y + context.px(5)});
        if (cross_button(context, id + ".close"))
            plots.shown.erase(plots.shown.begin() + static_cast<long>(slot.number));
    }
    if (!slot.adds) return;
    ImGui::SetCursorScreenPos({right - context.px(30), slot.area.y + context.px(3)});
    if (text_button(context, "plots.add", "+", false, context.px(26))) add_plot(plots);
    tooltip(context, "another plot");
}

/// Where what the axis up means stands in the line of controls.
float title_from(const Context& context, const Slot& slot) {
    return slot.area.x + kind_width(context, slot) + scale_width(context, slot.area) + context.px(8 + 6 + 10);
}

bool has_room_for_title(const Context& context, const plot::Plot& plot, const Slot& slot) {
    const WithFont font(context.theme.fonts().small);
    const float room = slot.area.right() - context.px(slot.adds ? 100 : 72) - title_from(context, slot);
    return context.is_saved() || ImGui::CalcTextSize(plot.title.c_str()).x <= room;
}

/// The controls of a plot, and what its axis up means where there is room beside them; in a picture that is saved the
/// latter alone.
void draw_header(const Context& context, const plot::Plot& plot, const Slot& slot) {
    const Area& area = slot.area;
    const float y = area.y + context.px(0.5f * header + 3);
    if (context.is_saved()) {
        const WithFont font(context.theme.fonts().heading);
        const std::string title = shortened(plot.title, area.width - context.px(28));
        return text_left(area.x + context.px(14), y, title, colour::text);
    }
    ImGui::SetCursorScreenPos({area.x + context.px(8), area.y + context.px(3)});
    draw_kind(context, slot);
    ImGui::SameLine(0, context.px(6));
    draw_scale_up(context, slot.choice(context), area);
    const WithFont font(context.theme.fonts().small);
    if (has_room_for_title(context, plot, slot)) text_left(title_from(context, slot), y, plot.title, colour::text_dim);
    draw_count(context, slot);
}

void draw_chosen(const Context& context, const Slot& slot) {
    const Area& area = slot.area;
    PlotChoice& choice = slot.choice(context);
    const plot::Plot plot = plot_of(context, choice);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({area.x, area.y}, {area.right(), area.bottom()}, colour::panel, context.px(5));
    list.AddRect({area.x, area.y}, {area.right(), area.bottom()}, colour::line, context.px(5));
    draw_plot(context, plot, area, !has_room_for_title(context, plot, slot));
    const plot::Layout layout = plot_layout(context.theme, plot, area);
    move_axes(context, plot, layout, area, choice, is_steered(context, slot));
    if (shows_costs(choice.kind)) use_costs(context, choice.kind, layout);
    if (!context.is_saved()) draw_scale_across(context, choice, area, layout.frame);
    draw_header(context, plot, slot);  // may take it away
}

void begin_plots(const char* name, const Area& area) {
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colour::backdrop);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBringToFrontOnFocus);
}

void end_plots() {
    ImGui::End();
    ImGui::PopStyleColor();
}

/// Brings a plot that has no room to where plots are shown.
void show(PlotsState& plots, std::size_t number, const PlotPlaces& places) {
    if (number < places.first) plots.first = number;
    if (number >= places.first + places.plots.size()) plots.first = number + 1 - places.plots.size();
}

/// The names of all chosen plots; those that are shown are underlined.
void draw_plot_tabs(const Context& context, const PlotPlaces& places) {
    const WithFont font(context.theme.fonts().small);
    const auto& shown = context.state.plots.shown;
    const float width = std::floor(places.tabs.width / static_cast<float>(shown.size()));
    for (std::size_t number = 0; number < shown.size(); ++number) {
        const PlotKindInfo& info = info_of(shown[number].kind);
        const std::string widget = std::string(info.id) + ".tab";
        const WithId id(widget);
        ImGui::SetCursorScreenPos({places.tabs.x + static_cast<float>(number) * width, places.tabs.y});
        if (ImGui::InvisibleButton("tab", {width, places.tabs.height})) show(context.state.plots, number, places);
        context.mark(widget);
        tooltip(context, info.what);
        draw_tab_name(context, shortened(info.name, width - context.px(8)),
                      number >= places.first && number < places.first + places.plots.size());
    }
}

/// On its own, beside all else.
void draw_pictured_plot(const Context& context, const PicturedPlot& pictured) {
    const auto& shown = context.state.plots.shown;
    const auto chosen = std::find_if(
        shown.begin(), shown.end(), [&](const PlotChoice& choice) { return info_of(choice.kind).id == pictured.name; });
    if (chosen == shown.end()) return;
    begin_plots("plot", pictured.area);
    draw_chosen(context, {static_cast<std::size_t>(chosen - shown.begin()), pictured.area});
    end_plots();
}

}  // namespace

void draw_plots_panel(const Context& context) {
    if (const auto& pictured = context.state.plots.pictured) draw_pictured_plot(context, *pictured);
    ask_for_samples(context);
    const PlotPlaces places = places_of(context);
    ask_for_costs(context, places);
    const Area& area = context.layout.plots;
    if (area.empty()) return;
    begin_plots("plots", area);
    if (!places.tabs.empty()) draw_plot_tabs(context, places);
    for (std::size_t i = 0; i < places.plots.size() && places.first + i < context.state.plots.shown.size(); ++i)
        draw_chosen(context, {places.first + i, places.plots[i],
                              i + 1 == places.plots.size() && context.state.plots.shown.size() < PlotsState::most});
    end_plots();
}

}  // namespace steplab::ui
