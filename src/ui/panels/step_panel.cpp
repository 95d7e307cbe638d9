#include "core/number_text.hpp"
#include "core/terms.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/step_verdict.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/parameter_rows.hpp"
#include "ui/widgets/slider.hpp"
#include "ui/widgets/widgets.hpp"

#include <cmath>

namespace steplab::ui {
namespace {

/// Of the run as it is: nothing is said of a change that it has not made yet.
StepVerdict shown_verdict(const Context& context) {
    if (context.description() == context.view.description)
        return step_verdict(context.view, context.session.present.get());
    return {Lamp::none, "waiting for the run", {}, "the change has been requested"};
}

ImU32 ink_of(Lamp lamp, ImU32 none) {
    switch (lamp) {
        case Lamp::good:
            return colour::good;
        case Lamp::caution:
            return colour::caution;
        case Lamp::bad:
            return colour::bad;
        case Lamp::none:
            break;
    }
    return none;
}

/// In room for any verdict: that of a run that goes on moves nothing below it.
void draw_verdict(const Context& context, const StepVerdict& verdict) {
    const WithFont font(context.theme.fonts().small);
    const ImU32 ink = ink_of(verdict.lamp, colour::text_dim);
    const float radius = context.px(3.5f), indent = context.px(14);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float y = corner.y + 0.5f * ImGui::GetTextLineHeight();
    if (verdict.lamp != Lamp::none)
        ImGui::GetWindowDrawList()->AddCircleFilled({corner.x + radius + 1, y}, radius, ink);
    ImGui::Indent(indent);
    explanation(context, verdict.text, ink);
    term_tooltip(context, verdict.tooltip, verdict.text);
    const auto lines = [&](const std::string& text) { return lines_of_explanation(context, text); };
    const int most = lines(longest_verdict().text) + lines(longest_verdict().detail);
    const bool given = chooses_its_steps(context.description());  // what is said of its steps never changes
    if (!given) {
        changing_explanation(context, verdict.detail, most - lines(verdict.text));
        term_tooltip(context, verdict.tooltip, "steps per period, numerical damping");
    }
    ImGui::Unindent(indent);
}

/// The stability limit, as long as it is that of the scene and method on the panel.
std::optional<double> limit_mark(const Context& context) {
    RunDescription asked = context.description();
    asked.dt = context.view.description.dt;
    if (asked != context.view.description) return std::nullopt;
    const auto& present = context.session.present;
    const auto& at_rest = context.view.limit;
    const auto limit = present ? present->limit : at_rest ? std::optional(at_rest->limit) : std::nullopt;
    return limit && *limit > 0 && !std::isinf(*limit) ? limit : std::nullopt;
}

}  // namespace

void draw_step_panel(const Context& context) {
    const RunDescription description = context.description();
    const auto ask = [&](double dt) {
        RunDescription changed = description;
        changed.dt = dt;
        context.ask(changed);
    };
    const StepVerdict verdict = shown_verdict(context);
    ParameterInfo info = dt_parameter;
    info.default_value = context.view.opening_dt;
    const std::string help = with_explanations(parameter_help(info), info.name);
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
                            .style = {.fill = ink_of(verdict.lamp, colour::accent), .mark = limit_mark(context)},
                            .set = ask,
                            .set_text = [&](std::string_view typed) { ask(parse_value(info, typed)); },
                        });
    draw_verdict(context, verdict);
}

}  // namespace steplab::ui
