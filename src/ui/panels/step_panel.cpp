#include "lab/study/answers.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/parameter_rows.hpp"
#include "ui/widgets/slider.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <cmath>

namespace steplab::ui {
namespace {

/// What dt is to a method that chooses its steps, else what the linear theory says of it: the line below the slider.
struct Verdict {
    std::string text;
    ImU32 ink = colour::text_dim;
    bool passed = false;  ///< dt is beyond the limit
};

Verdict verdict(const std::optional<StabilityLimit>& known, const RunDescription& description) {
    if (chooses_its_steps(description)) return {"the method chooses its own steps", colour::good};
    if (!known) return {"stability limit not known"};
    if (known->limit == 0) return {"unstable at any dt: the energy grows", colour::bad, true};
    if (std::isinf(known->limit)) return {"stable at any dt", colour::good};
    const double part = description.dt / known->limit;
    const std::string share = part < 0.01 ? "< 0.01" : fmt::format("{:.2f}", part);
    const std::string of_limit = fmt::format("{} of limit {} s, ω_max {}", part < 10 ? share : scientific(part),
                                             reading(known->limit), reading(known->omega_max));
    if (part > 1) return {"unstable: " + of_limit, colour::bad, true};
    return {"stable: " + of_limit, colour::good};
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
}

}  // namespace

void draw_step_panel(const Context& context) {
    const RunDescription description = context.description();
    const auto ask = [&](double dt) {
        RunDescription changed = description;
        changed.dt = dt;
        context.ask(changed);
    };
    // The run's own limit is that of what is being computed; while a change is on its way, the one asked for counts.
    const bool current = description == context.view.description;
    const auto limit = current ? context.view.limit : stability_limit(description);
    const Verdict result = verdict(limit, description);
    const bool marked = limit && limit->limit > 0 && std::isfinite(limit->limit);
    const ParameterInfo& info = dt_parameter;
    const std::string help = parameter_help(info);
    heading(context, "STEP");
    slider_row(context, {
                            .widget = "dt",
                            .label = info.name,
                            .tooltip = help,
                            .value_text = with_unit(number(description.dt), info.unit),
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
}

}  // namespace steplab::ui
