#include "core/number_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/parameter_rows.hpp"
#include "ui/widgets/slider.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <cmath>

namespace steplab::ui {
namespace {

/// How dt stands to the stability limit: the line below the slider, and its tooltip.
struct Verdict {
    std::string text;
    ImU32 ink = colour::text_dim;
    bool passed = false;  ///< dt is beyond the limit
    std::string tooltip = "from linear theory for the scene at rest";
};

std::string share_text(double share) {
    if (share < 0.01) return "< 0.01";
    return share < 10 ? fmt::format("{:.2f}", share) : rounded_text(share);
}

Verdict verdict(const std::optional<StabilityLimit>& known, const RunDescription& description) {
    if (chooses_its_steps(description))
        return {.text = "step size chosen by the method",
                .ink = colour::good,
                .tooltip = "the method keeps its tolerance; dt is the time between two frames"};
    if (!known) return {.text = "stability limit unknown", .tooltip = "linear theory does not cover this scene"};
    if (known->limit == 0) return {.text = "unstable at any dt: the energy grows", .ink = colour::bad, .passed = true};
    if (std::isinf(known->limit)) return {.text = "stable at any dt", .ink = colour::good};
    const bool unstable = description.dt > known->limit;
    return {.text = fmt::format("{}: {} of the limit {} s", unstable ? "unstable" : "stable",
                                share_text(description.dt / known->limit), reading_text(known->limit)),
            .ink = unstable ? colour::bad : colour::good,
            .passed = unstable,
            .tooltip = fmt::format("dt relative to the stability limit, from linear theory for the scene at rest;\n"
                                   "largest angular frequency ω_max = {} rad/s",
                                   reading_text(known->omega_max))};
}

void draw_verdict(const Context& context, const Verdict& verdict) {
    const WithFont font(context.theme.fonts().small);
    const float radius = context.px(3.5f);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float y = corner.y + 0.5f * ImGui::GetTextLineHeight();
    if (verdict.ink != colour::text_dim) {
        ImGui::GetWindowDrawList()->AddCircleFilled({corner.x + radius + 1, y}, radius, verdict.ink);
        ImGui::SetCursorScreenPos({corner.x + context.px(14), corner.y});
    }
    explanation(context, verdict.text, verdict.ink);
    tooltip(context, verdict.tooltip);
}

}  // namespace

void draw_step_panel(const Context& context) {
    const RunDescription description = context.description();
    const auto ask = [&](double dt) {
        RunDescription changed = description;
        changed.dt = dt;
        context.ask(changed);
    };
    // While a change is on its way to the run, the limit is that of the requested description.
    const bool current = description == context.view.description;
    const auto limit = current ? context.view.limit : stability_limit(description);
    const Verdict result = verdict(limit, description);
    const bool marked = limit && limit->limit > 0 && std::isfinite(limit->limit);
    const ParameterInfo& info = dt_parameter;
    const std::string help = parameter_help(info);
    heading(context, "TIME STEP");
    slider_row(context, {
                            .widget = "dt",
                            .label = info.name,
                            .tooltip = help,
                            .value_text = with_unit(setting_text(description.dt), info.unit),
                            .entry_text = format_value(info, description.dt),
                            .value = description.dt,
                            .default_value = info.default_value,
                            .range = {info.slider_low, info.slider_high, info.slider_logarithmic, false},
                            .style = {.fill = result.passed ? colour::bad
                                              : limit       ? colour::good
                                                            : colour::accent,
                                      .mark = marked ? std::optional(limit->limit) : std::nullopt},
                            .set = ask,
                            .set_text = [&](std::string_view typed) { ask(parse_value(info, typed)); },
                        });
    draw_verdict(context, result);
    for (const std::string& note : context.view.notes) explanation(context, note, colour::text);
}

}  // namespace steplab::ui
