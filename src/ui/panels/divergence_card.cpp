#include "core/number_text.hpp"
#include "sim/catalogue.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/cards.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

namespace steplab::ui {
namespace {

RunDescription with_dt(RunDescription description, double dt) {
    description.dt = dt;
    return description;
}

/// Restarts the run with the remedy: the last valid state already has the energy of the blow-up.
void apply(const Context& context, const RunDescription& remedy) {
    context.ask(remedy);
    context.events.send(event::Restart{});
    context.state.wanted.play(true, context.events);
}

void draw_buttons(const Context& context, const Remedies& remedies) {
    const RunDescription& now = context.description();
    auto next = [&, first = true]() mutable {
        if (!first) ImGui::SameLine();
        first = false;
    };
    if (remedies.dt) {
        next();
        const std::string text = fmt::format("Use dt = {} s", setting_text(*remedies.dt));
        if (text_button(context, "remedy.dt", text, true)) apply(context, with_dt(now, *remedies.dt));
    }
    if (remedies.method) {
        next();
        const std::string text = fmt::format("Use {}", method(*remedies.method).info.name);
        if (text_button(context, "remedy.method", text, !remedies.dt))
            apply(context, with_method(now, *remedies.method));
    }
    next();
    if (text_button(context, "remedy.restart", "Restart")) context.events.send(event::Restart{});
}

ImVec2 anchor(const Context& context) {
    const Area& scene = context.layout.scene;
    return {scene.x + 0.5f * scene.width, scene.y + 0.42f * scene.height};
}

void draw_title(const Context& context, const char* text) {
    const WithFont font(context.theme.fonts().strong);
    ImGui::TextUnformatted(text);
}

void draw_doubt(const Context& context, const Doubt& doubt) {
    const Card card(context, "doubt", anchor(context), {0.5f, 0.5f}, card_width(context, 430), colour::bad);
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
        if (context.state.doubt) draw_doubt(context, *context.state.doubt);
        return;
    }
    if (dismissed == divergence->step) return;
    const Card card(context, "divergence", anchor(context), {0.5f, 0.5f}, card_width(context, 430), colour::bad);
    if (close_cross(context, "divergence.close")) dismissed = divergence->step;
    draw_title(context, divergence->stop ? "The run stopped" : "The run diverged");
    explanation(context, divergence->message, colour::text);
    ImGui::Dummy({0, context.px(4)});
    draw_buttons(context, context.view.remedies);
}

}  // namespace steplab::ui
