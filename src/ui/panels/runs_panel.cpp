#include "core/number_text.hpp"
#include "session/run_name.hpp"
#include "session/session.hpp"
#include "sim/catalogue.hpp"
#include "ui/actions.hpp"
#include "ui/panels/late_errors.hpp"
#include "ui/panels/method_items.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/icons.hpp"
#include "ui/widgets/run_marks.hpp"
#include "ui/widgets/slider.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

/// As the picture shows it.
const RunView& run_of(const Context& context, std::size_t run) {
    return run == 0 ? context.pictured.leading : context.pictured.followers[run - 1];
}

std::size_t runs_of(const Context& context) { return 1 + context.session.followers.size(); }

const Compared* compared_of(const Context& context, std::size_t run) {
    const auto& errors = context.pictured.errors;
    return errors && run < errors->runs.size() && errors->runs[run] ? &*errors->runs[run] : nullptr;
}

/// The error, of the time for which the reference is known, or why it is not known.
std::string position_error_text(const Context& context, std::size_t run) {
    const auto& errors = context.pictured.errors;
    if (errors && errors->runs.empty()) return "error unknown: " + errors->how;
    const Compared* const compared = compared_of(context, run);
    if (!compared) return "computing the reference";
    std::string text = fmt::format("error\u00a0{}\u00a0m", error_text(compared->error));
    if (!are_late(*errors, context.pictured.leading)) return text;
    return text + fmt::format("\u00a0at\u00a0t\u00a0=\u00a0{}\u00a0s", typed(errors->time, 3));
}

/// "error 1.2e-3 m · energy 4e-6 J · 156 evaluations": what is known of them. Lines break between them only.
std::string errors_text(const Context& context, std::size_t run) {
    const RunView& view = run_of(context, run);
    if (view.divergence) return fmt::format("diverged at t = {} s", typed(view.divergence->time, 4));
    std::string text = position_error_text(context, run);
    if (view.energy_error) text += fmt::format(" · energy\u00a0{}\u00a0J", error_text(*view.energy_error));
    return text + fmt::format(" · {}\u00a0evaluations", count_text(static_cast<double>(view.evaluations)));
}

constexpr std::string_view longest_errors_text =
    "error\u00a08.8e-88\u00a0m · energy\u00a0-8.8e-88\u00a0J · 8.88e88\u00a0evaluations";

/// The rest of what is known of them.
std::string more_errors_text(const Compared& compared, const std::optional<double>& cost) {
    std::string text =
        fmt::format("t = {} s: largest error of a position {}, root mean square {}", typed(compared.time, 6),
                    with_unit(error_text(compared.error), "m"), with_unit(error_text(compared.rms_error), "m"));
    if (compared.energy_error) text += "\nenergy error " + with_unit(error_text(*compared.energy_error), "J");
    if (compared.momentum_error)
        text += "\nmomentum error " + with_unit(error_text(*compared.momentum_error), "kg m/s");
    if (compared.phase_error) {
        text +=
            fmt::format("\nphase error {}, {} the motion", with_unit(error_text(std::abs(*compared.phase_error)), "s"),
                        *compared.phase_error < 0 ? "behind" : "ahead of");
    }
    const double rate = static_cast<double>(compared.evaluations) / compared.time;
    if (compared.time > 0) text += fmt::format("\n{} force evaluations per simulated second", frequency_text(rate));
    if (cost) text += fmt::format("\n{} ns of computing per simulated second", rounded_text(1e9 * *cost));
    return text;
}

/// Where the run stands beside the leading one, if not at the same time.
std::string offset_text(const Context& context, std::size_t run) {
    const double late = run_of(context, 0).frame.time - run_of(context, run).frame.time;
    if (run == 0 || late <= 1e-6 * context.view.dt) return {};
    return fmt::format("shown {} s before, at its last step\n", typed(late, 3));
}

void draw_swatch(const Context& context, std::size_t run) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = context.px(22), y = corner.y + 0.5f * ImGui::GetTextLineHeight();
    const std::size_t swatch = context.run(run).swatch;
    draw_run_line(*ImGui::GetWindowDrawList(), {corner.x, y}, width, swatch,
                  run_ink(context.stage.style.background, swatch), context.px(2.5f));
    ImGui::Dummy({width, ImGui::GetTextLineHeight()});
    ImGui::SameLine(0, context.px(8));
}

/// What the pointer is told of a run at its name: the whole name, its errors, what a click does.
std::string told_of_run(const Context& context, std::size_t run, const std::string& title) {
    std::string text = title + "\n" + offset_text(context, run);
    if (const Compared* const compared = compared_of(context, run))
        text += more_errors_text(*compared, run_of(context, run).cost) + "\n";
    return text + (run == 0 ? "the leading run: settings and time line are its own"
                            : "click to make it the leading run, whose settings are shown");
}

/// A click on the name of a run makes it lead: the other sections are then its settings.
void draw_run(const Context& context, std::size_t run) {
    const std::string widget = fmt::format("run {}", run);
    const WithId id(widget);
    draw_swatch(context, run);
    const std::string title =
        run_name(run == 0 ? context.description() : run_of(context, run).description, context.view.description);
    const WithFont font(run == 0 ? context.theme.fonts().strong : context.theme.fonts().body);
    const float room = std::max(1.0f, ImGui::GetContentRegionAvail().x - context.px(22));
    const bool clicked = ImGui::InvisibleButton("lead", {room, ImGui::GetTextLineHeight()});
    context.mark(widget);
    const ImVec2 corner = ImGui::GetItemRectMin();
    text_left(corner.x, 0.5f * (corner.y + ImGui::GetItemRectMax().y), shortened(title, room),
              ImGui::IsItemHovered() && run > 0 ? colour::bright : colour::text);
    tooltip(context, told_of_run(context, run, title));
    if (clicked && run > 0) context.events.send(event::Lead{run});
    ImGui::SameLine(0, context.px(4));
    if (cross_button(context, widget + ".remove")) context.events.send(event::RemoveRun{run});
}

void draw_errors(const Context& context, std::size_t run) {
    const WithFont font(context.theme.fonts().small);
    changing_explanation(context, errors_text(context, run), lines_of_explanation(context, longest_errors_text));
    if (const Compared* const compared = compared_of(context, run))
        term_tooltip(context, more_errors_text(*compared, run_of(context, run).cost), "position error, phase error");
}

/// What the errors are measured against; empty where that is not known yet.
std::string reference_text(const Context& context) {
    const auto& errors = context.pictured.errors;
    if (!errors || errors->runs.empty()) return {};
    std::string text = errors->exact ? "against the exact solution" : "against a reference run";
    if (are_late(*errors, context.pictured.leading))
        text += fmt::format(", which is at t = {} s", typed(errors->time, 4));
    if (const Compared* const lead = compared_of(context, 0); lead && !errors->exact)
        text += fmt::format(", accurate to {}\u00a0m", error_text(lead->reference_error));
    return text;
}

void draw_reference(const Context& context) {
    const bool exact = context.view.why_not_exact.empty();
    const char* const longest = exact
                                    ? "against the exact solution"
                                    : "against a reference run, which is at t = 8.888e88 s, accurate to 8.8e-88\u00a0m";
    const std::string text = reference_text(context);
    changing_explanation(context, text, lines_of_explanation(context, longest), colour::text_faint);
    if (!text.empty()) term_tooltip(context, context.pictured.errors->how, text);
}

constexpr ParameterInfo magnify_info{.name = "magnify",
                                     .unit = "",
                                     .minimum = 1,
                                     .maximum = render::most_magnified,
                                     .default_value = 1,
                                     .what = "how many times the distances to the leading run are drawn"};

void draw_magnify(const Context& context) {
    double& factor = context.stage.style.magnify;
    slider_row(context, {.widget = "magnify",
                         .label = "differences",
                         .tooltip = "how many times as far as they are the ghosts are drawn from the leading run",
                         .value_text = rounded_text(factor),
                         .entry_text = typed(factor),
                         .value = factor,
                         .default_value = 1,
                         .range = {1, 1e6, true, false},
                         .style = {},
                         .set = [&](double value) { factor = value; },
                         .set_text = [&](std::string_view text) { factor = parse_value(magnify_info, text); }});
}

/// How the runs are shown, and at what cost they run.
void draw_together(const Context& context) {
    auto layout = static_cast<std::size_t>(context.stage.style.layout);
    if (segmented(context, "layout", render::run_layout_ids, layout, context.px(150), ImGui::GetFrameHeight()))
        context.stage.style.layout = static_cast<render::RunLayout>(layout);
    if (context.stage.style.layout == render::RunLayout::ghosts) draw_magnify(context);
    bool equal = context.session.equal_cost;
    if (check_row(context, "equal cost", "equal cost", equal)) context.events.send(event::EqualCost{equal});
    term_tooltip(context,
                 "each run gets the dt, or the tolerance, at which it costs as many force evaluations per simulated "
                 "second as the leading one; it begins again with it. Undo gives each what it had before",
                 "force evaluations");
    if (!context.session.not_equal.empty()) explanation(context, context.session.not_equal);
}

void draw_add(const Context& context) {
    std::size_t none = 0;
    std::vector<ComboItem> items{{.id = "", .name = "+ method"}};
    for (ComboItem& item : method_items(context.view)) items.push_back(std::move(item));
    if (combo(context, "add run", items, none, context.px(104)))
        context.events.send(event::AddRun{with_method(context.description(), items[none].id)});
    ImGui::SameLine(0, context.px(6));
}

/// How the time line is played, besides the buttons of the bar.
void draw_time_buttons(const Context& context) {
    const bool backwards = context.state.wanted.playing() && context.session.line.backwards;
    if (icon_button(context, "play back", backwards ? Icon::pause : Icon::play_back, help_of(Action::play_back)))
        perform(context, Action::play_back);
    ImGui::SameLine(0, context.px(4));
    if (icon_button(context, "loop", Icon::loop, help_of(Action::loop),
                    context.session.line.loop ? ButtonStyle::accent : ButtonStyle::plain))
        perform(context, Action::loop);
    ImGui::SameLine(0, context.px(8));
}

/// What makes several runs of one, and what all of them do.
void draw_buttons(const Context& context) {
    if (runs_of(context) < Session::most_runs) draw_add(context);
    if (text_button(context, "twin", "twin", false, context.px(58))) perform(context, Action::twin);
    term_tooltip(context, help_of(Action::twin), "twin, rounding");
    ImGui::SameLine(0, context.px(6));
    if (text_button(context, "turn round", "turn round", false, context.px(92))) perform(context, Action::turn_round);
    term_tooltip(context,
                 context.view.facts.drag > 0 ? "all velocities are turned round; with drag the motion does not return"
                                             : help_of(Action::turn_round),
                 "time-reversible");
}

/// What makes a run of a trajectory.
void draw_continue(const Context& context) {
    if (!context.session.playback->measured) return;
    if (text_button(context, "continue", "continue from here")) continue_from_here(context);
    tooltip(context, "begin a run with the positions and velocities of this frame; it can be changed like any other");
}

}  // namespace

void draw_run_buttons(const Context& context) {
    const Area& area = context.layout.run_buttons;
    if (area.empty()) return;
    const StripWindow strip(context, "run buttons", area);
    draw_time_buttons(context);
    context.session.playback ? draw_continue(context) : draw_buttons(context);
}

/// A run alone needs no list: the sections below are its settings.
void draw_runs_panel(const Context& context) {
    if (runs_of(context) == 1) return;
    heading(context, "RUNS");
    for (std::size_t run = 0; run < runs_of(context); ++run) {
        draw_run(context, run);
        draw_errors(context, run);
    }
    draw_reference(context);
    draw_together(context);
}

}  // namespace steplab::ui
