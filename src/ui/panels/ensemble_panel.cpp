#include "core/number_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/slider.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace steplab::ui {
namespace {

constexpr std::array<std::size_t, 4> numbers_of_runs{0, 16, 64, 256};
constexpr std::array<std::string_view, 4> names_of_numbers{"off", "16", "64", "256"};

void draw_number(const Context& context, const LiveEnsembleOptions& ensemble) {
    const RowPlaces places = row_places(context);
    row_label(
        context, "ensemble",
        "number of perturbed runs of the same scene, computed and drawn with this one;\nif the motion is chaotic, "
        "they diverge from it exponentially");
    ImGui::SameLine(places.control);
    const auto found = std::find(numbers_of_runs.begin(), numbers_of_runs.end(), ensemble.runs);
    auto chosen = static_cast<std::size_t>(found - numbers_of_runs.begin());
    if (!segmented(context, "ensemble", names_of_numbers, chosen, places.right - places.control, row_height(context)))
        return;
    LiveEnsembleOptions changed = ensemble;
    changed.runs = numbers_of_runs[chosen];
    context.state.wanted.show_ensemble(changed, context.events);
}

void draw_perturbed_parameter(const Context& context, const LiveEnsembleOptions& ensemble) {
    const RowPlaces places = row_places(context);
    row_label(
        context, "perturb",
        "parameter that differs between the runs of the ensemble; its values are spaced evenly\na change restarts "
        "the ensemble",
        ImGui::GetFrameHeight());
    ImGui::SameLine(places.control);
    const std::vector<std::string_view> names = perturbable(context.description());
    std::vector<ComboItem> items;
    items.reserve(names.size());
    for (const std::string_view name : names) items.push_back({.id = name, .name = name});
    const std::string shown = range_of(ensemble, context.description()).name;
    auto chosen = static_cast<std::size_t>(std::find(names.begin(), names.end(), shown) - names.begin());
    if (!combo(context, "ensemble spread", items, chosen, places.right - places.control)) return;
    LiveEnsembleOptions changed = ensemble;
    changed.spread = names[chosen];
    context.state.wanted.show_ensemble(changed, context.events);
}

constexpr ParameterInfo width_info{.name = "perturbation",
                                   .unit = "",
                                   .maximum = LiveEnsembleOptions::most_width,
                                   .default_value = LiveEnsembleOptions::usual_width,
                                   .what = "relative perturbation"};

void draw_width(const Context& context, const LiveEnsembleOptions& ensemble) {
    const auto set = [&](double width) {
        LiveEnsembleOptions changed = ensemble;
        changed.width = width;
        context.state.wanted.show_ensemble(changed, context.events);
    };
    const std::string help = fmt::format(
        "largest perturbation relative to the value of this run\n{} · default {}\na change restarts the ensemble",
        range_text(width_info), rounded_text(width_info.default_value));
    slider_row(context, {.widget = "ensemble width",
                         .label = "by ±",
                         .tooltip = help,
                         .value_text = rounded_text(ensemble.width),
                         .entry_text = format_value(width_info, ensemble.width),
                         .value = ensemble.width,
                         .default_value = width_info.default_value,
                         .range = {1e-15, 0.1, true, false},
                         .style = {},
                         .set = set,
                         .set_text = [&](std::string_view typed) { set(parse_value(width_info, typed)); }});
}

constexpr std::string_view longest_spread_text = "spread: max 8.8e-88 m, rms 8.8e-88 m, 888 runs diverged";

/// "spread: max 0.031 m, rms 2.1e-3 m"
std::string spread_text(const RunView& view) {
    const EnsembleSpread& reading = view.ensemble_spread;
    if (view.frame.ensemble.empty()) return fmt::format("computing: step {} of {}", reading.step, view.frame.step);
    std::string text = fmt::format("spread: max {}, rms {}", with_unit(error_text(reading.largest), "m"),
                                   with_unit(error_text(reading.root_mean_square), "m"));
    if (reading.lost > 0)
        text += fmt::format(", {} diverged", counted(static_cast<double>(reading.lost), "run", "runs"));
    return text;
}

}  // namespace

void draw_ensemble_rows(const Context& context) {
    const LiveEnsembleOptions ensemble = context.state.wanted.ensemble();
    draw_number(context, ensemble);
    if (ensemble.runs == 0) return;
    if (!ensemble.otherwise) {
        draw_perturbed_parameter(context, ensemble);
        draw_width(context, ensemble);
    }
    changing_explanation(context, spread_text(context.view), lines_of_explanation(context, longest_spread_text));
}

}  // namespace steplab::ui
