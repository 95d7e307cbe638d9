#include "core/number_text.hpp"
#include "session/run_name.hpp"
#include "sim/catalogue.hpp"
#include "ui/panels/card_corner.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/cards.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace steplab::ui {
namespace {

/// Restarts the run with the remedy: the last valid state already has the energy of the blow-up.
void apply(const Context& context, const RunDescription& remedy) {
    context.ask(remedy);
    context.events.send(event::Restart{});
    context.state.wanted.play(true, context.events);
}

/// "tried for 12.5 s: energy error 0.2 %, 4 times the cost"
std::string trial_text(const TriedRemedy& tried) {
    std::string text =
        tried.from == 0 ? fmt::format("tried for {} s", reading_text(std::abs(tried.until)))
                        : fmt::format("tried from t = {} to {} s", reading_text(tried.from), reading_text(tried.until));
    if (tried.energy_error) text += fmt::format(": energy error {} %", rounded_text(100 * *tried.energy_error));
    const std::string cost = rounded_text(tried.cost);
    return text + (cost == "1" ? ", the same cost" : fmt::format(", {} times the cost", cost));
}

/// A remedy that worked, and how well.
void draw_remedy(const Context& context, const TriedRemedy& tried, bool first) {
    const bool of_dt = tried.run.method == context.view.description.method;
    const std::string text = of_dt ? fmt::format("Use dt = {} s", setting_text(tried.run.dt))
                                   : fmt::format("Use {}", method(tried.run.method).info.name);
    if (text_button(context, of_dt ? "remedy.dt" : "remedy.method", text, first)) apply(context, tried.run);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    explanation(context, trial_text(tried));
    context.mark(of_dt ? "remedy.dt.trial" : "remedy.method.trial");
    tooltip(context,
            "energy error: the largest |E - E0| of the trial over the energy at its start; cost: force evaluations per "
            "simulated second, beside those of the run that diverged");
}

void draw_remedies(const Context& context, const BlowUp& blow_up) {
    bool any = false;
    for (const TriedRemedy& tried : blow_up.tried) {
        if (!tried.works) continue;
        draw_remedy(context, tried, !any);
        any = true;
    }
    if (!blow_up.complete) {
        explanation(context, "trying remedies ...");
    } else if (!any && !blow_up.tried.empty()) {
        explanation(context, fmt::format("{} other dt and methods were tried: none works", blow_up.tried.size()));
    }
}

/// Back to where the energy began to rise, with the oscillation that grew as arrows.
void show_beginning(const Context& context, const BlowUp& blow_up) {
    constexpr std::uint64_t steps_before = 20;
    context.events.send(event::Play{.on = false});
    context.events.send(event::Seek{blow_up.step - std::min(blow_up.step, steps_before)});
    context.state.oscillation = true;
    context.state.oscillation_of = context.view.run;
}

/// Beside it may be a run that goes on.
void draw_other_run(const Context& context) {
    const auto& followers = context.session.followers;
    const auto other =
        std::find_if(followers.begin(), followers.end(), [](const RunView& run) { return !run.divergence; });
    if (other == followers.end()) return;
    const std::string name = run_name(other->description, context.view.description);
    if (text_button(context, "divergence.lead", "Let " + name + " lead"))
        context.events.send(event::Lead{1 + static_cast<std::size_t>(other - followers.begin())});
    tooltip(context, "that run goes on; this one stays beside it");
}

/// The next button goes beside the one before, where it has room.
void stay_in_line(const char* text) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::CalcTextSize(text).x + 2 * style.FramePadding.x;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right) ImGui::SameLine();
}

void draw_ways_on(const Context& context) {
    const auto& blow_up = context.session.blow_up;
    if (blow_up) {
        if (text_button(context, "divergence.beginning", "Show how it began")) show_beginning(context, *blow_up);
        tooltip(context, "goes to 20 steps before the energy rose; the arrows show the oscillation that grew");
        stay_in_line("Restart");
    }
    if (text_button(context, "remedy.restart", "Restart")) context.events.send(event::Restart{});
    stay_in_line("Read more");
    if (text_button(context, "divergence.page", "Read more"))
        context.request({.kind = Request::Kind::open_page, .text = "divergence.md"});
    tooltip(context, "opens docs/divergence.md: when a run counts as diverged, and why runs diverge");
}

void draw_title(const Context& context, const char* text) {
    const WithFont font(context.theme.fonts().strong);
    ImGui::TextUnformatted(text);
}

/// "The run diverged: step 12 ..." below that title.
std::string without_title(const std::string& message) {
    const std::size_t end = message.find(": ");
    if (end == std::string::npos) return message;
    std::string rest = message.substr(end + 2);
    if (rest.starts_with("step ")) rest.front() = 'S';
    return rest;
}

/// "1.434 s: stability limit ..."; nothing where no dt is stable, or any.
std::string limit_line(const std::optional<double>& limit, const std::string& of) {
    if (!limit || !(*limit > 0) || std::isinf(*limit)) return {};
    return fmt::format("{} s: stability limit of the {}", reading_text(*limit), of);
}

/// What the sentence about the last good step says of a limit.
void explain_message(const Context& context, const Divergence& divergence) {
    const std::string line = limit_line(divergence.limit, "scene at rest, with its settings of now");
    if (!line.empty()) term_tooltip(context, line, "stability limit");
}

/// Which limits the paragraph about the cause speaks of.
void explain_cause(const Context& context, const BlowUp& blow_up) {
    const PresentLimit &start = blow_up.start, &then = blow_up.limit;
    std::string lines = limit_line(start.limit, "scene as it stood at the start of the run");
    const std::string later = limit_line(
        then.limit,
        fmt::format("scene as it stood at t = {} s, when it was smallest beside dt", reading_text(then.time)));
    if (then.step != start.step && !later.empty()) lines += (lines.empty() ? "" : "\n") + later;
    if (!lines.empty()) term_tooltip(context, lines, "stability limit");
}

/// Between the parts of the card, which has to be low.
void leave_gap(const Context& context) { ImGui::SetCursorPosY(ImGui::GetCursorPosY() + context.px(4)); }

/// Wide rather than high where the scene has room: scenes leave more of it above and below them than beside them.
float width_of_card(const Context& context) {
    return card_width(context, context.layout.scene.width >= context.px(840) ? 560 : 430);
}

void draw_doubt(const Context& context, const Doubt& doubt) {
    const auto [anchor, pivot] = card_corner(context, "doubt");
    const Card card(context, "doubt", anchor, pivot, width_of_card(context), colour::bad);
    draw_title(context, "The energy is impossible");
    explanation(
        context,
        fmt::format("It was found at step {} (t = {} s). The check at step {} decides whether the run diverged; "
                    "the run is at step {}.",
                    doubt.step, typed(doubt.time, 4), doubt.check, doubt.now),
        colour::text);
}

}  // namespace

void draw_divergence_card(const Context& context) {
    const auto& divergence = context.view.divergence;
    auto& dismissed = context.state.dismissed_divergence;
    if (!divergence) {
        dismissed.reset();
        if (!context.state.doubt) context.state.card_corner = 0;
        if (context.state.doubt) draw_doubt(context, *context.state.doubt);
        return;
    }
    if (dismissed == divergence->step) return;
    const auto [anchor, pivot] = card_corner(context, "divergence");
    const Card card(context, "divergence", anchor, pivot, width_of_card(context), colour::bad);
    if (close_cross(context, "divergence.close")) dismissed = divergence->step;
    draw_title(context, divergence->stop ? "The run stopped" : "The run diverged");
    explanation(context, without_title(divergence->message), colour::text);
    context.mark("divergence.message");
    explain_message(context, *divergence);
    if (const auto& blow_up = context.session.blow_up) {
        leave_gap(context);
        explanation(context, blow_up->why, colour::text);
        context.mark("divergence.why");
        explain_cause(context, *blow_up);
        leave_gap(context);
        draw_remedies(context, *blow_up);
    } else {
        explanation(context, "looking for the cause ...");
    }
    leave_gap(context);
    draw_ways_on(context);
    draw_other_run(context);
}

}  // namespace steplab::ui
