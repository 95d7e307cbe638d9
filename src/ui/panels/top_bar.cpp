#include "ui/actions.hpp"
#include "ui/panels/panels.hpp"
#include "ui/rate.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/icons.hpp"
#include "ui/widgets/slider.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace steplab::ui {
namespace {

constexpr std::array<std::string_view, 2> precisions = {id(Precision::float_), id(Precision::double_)};
constexpr float precision_width = 116;

void draw_action(const Context& context, std::string_view widget, Icon icon, Action action,
                 ButtonStyle style = ButtonStyle::plain, bool enabled = true) {
    if (icon_button(context, widget, icon, help_of(action), style, enabled)) perform(context, action);
    ImGui::SameLine(0, context.px(5));
}

void draw_transport(const Context& context) {
    const bool over = context.view.divergence.has_value();
    draw_action(context, "restart", Icon::restart, Action::restart);
    draw_action(context, "step back", Icon::step_back, Action::step_back, ButtonStyle::plain,
                context.view.can_step_back);
    draw_action(context, "play", context.state.wanted.playing() ? Icon::pause : Icon::play, Action::pause,
                ButtonStyle::accent, !over);
    draw_action(context, "step", Icon::step_forward, Action::step_forward, ButtonStyle::plain, !over);
}

void draw_speed(const Context& context) {
    Wanted& wanted = context.state.wanted;
    const Rate rate = wanted.rate();
    ImGui::SameLine(0, context.px(14));
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, colour::text_dim);
    ImGui::TextUnformatted("speed");
    ImGui::PopStyleColor();
    ImGui::SameLine(0, context.px(8));
    const SliderRange range{slowest, fastest, true, false};
    const double shown = rate.as_fast_as_possible ? fastest : rate.seconds_per_second;
    const SliderStyle style{.fill = rate.as_fast_as_possible ? colour::track : colour::accent};
    const auto moved = slider(context, "speed", shown, range, style, context.px(104), ImGui::GetFrameHeight());
    tooltip(context,
            "playback speed in simulated seconds per second of real time; keys = and - change it, a double click "
            "resets it");
    if (ImGui::IsItemHovered() && ImGui::GetIO().MouseDoubleClicked[0]) {
        wanted.set_rate({}, context.events);
    } else if (moved) {
        wanted.set_rate({false, *moved}, context.events);
    }
}

void draw_rate(const Context& context) {
    Wanted& wanted = context.state.wanted;
    const Rate rate = wanted.rate();
    ImGui::SameLine(0, context.px(8));
    const ImVec2 place = ImGui::GetCursorScreenPos();
    ImGui::Dummy({context.px(112), ImGui::GetFrameHeight()});
    if (!rate.as_fast_as_possible)
        text_left(place.x, place.y + 0.5f * ImGui::GetFrameHeight(), rate_text(rate.seconds_per_second), colour::text);
    ImGui::SameLine(0, context.px(6));
    if (text_button(context, "fastest", "unlimited", rate.as_fast_as_possible)) {
        wanted.set_rate({!rate.as_fast_as_possible, rate.seconds_per_second}, context.events);
    }
    tooltip(context, "run as fast as the processor allows; click again to return to the speed of the slider");
}

void draw_precision(const Context& context) {
    RunDescription description = context.description();
    auto chosen = static_cast<std::size_t>(description.precision);
    if (segmented(context, "precision", precisions, chosen, context.px(precision_width), ImGui::GetFrameHeight(),
                  "arithmetic of the whole run")) {
        description.precision = static_cast<Precision>(chosen);
        context.ask(description);
    }
}

/// What the bar says of the film that is taken; not in its own pictures.
std::optional<FilmStatus> told_film(const Context& context) {
    return context.is_saved() ? std::nullopt : context.state.film;
}

float record_width(const Context& context) { return context.px(told_film(context) ? 132 : 76); }

/// Begins a film; while one is taken, ends it, and says how long it is.
void draw_record(const Context& context) {
    const auto film = told_film(context);
    const std::string text =
        film ? fmt::format("{} \u00b7 {:.1f} s", counted(static_cast<double>(film->frames), "frame", "frames"),
                           film->seconds)
             : "Record";
    if (text_button(context, "record", text, film.has_value(), record_width(context))) perform(context, Action::record);
    tooltip(context, help_of(Action::record));
}

/// The group at the right end. It is placed from the right, so its width is computed first.
void draw_right_group(const Context& context) {
    const float gap = context.px(8);
    const float menu = ImGui::GetFrameHeight() + context.px(4);
    const float snapshot = ImGui::CalcTextSize("Snapshot").x + 2 * context.px(12);
    float x = context.layout.bar.right() - context.px(12) - menu;
    const float menu_x = x;
    if (context.layout.bar_has_snapshot) x -= snapshot + gap;
    const float snapshot_x = x;
    if (context.layout.bar_has_record) {
        x -= record_width(context) + gap;
        ImGui::SameLine(x);
        draw_record(context);
    }
    if (context.layout.bar_has_precision && !context.session.playback) {
        ImGui::SameLine(x - context.px(precision_width) - 2 * gap);
        draw_precision(context);
    }
    if (context.layout.bar_has_snapshot) {
        ImGui::SameLine(snapshot_x);
        if (text_button(context, "snapshot", "Snapshot")) perform(context, Action::snapshot);
        tooltip(context, help_of(Action::snapshot));
    }
    ImGui::SameLine(menu_x);
    draw_menu(context);
}

void draw_title(const Context& context) {
    const Area& bar = context.layout.bar;
    const WithFont font(context.theme.fonts().strong);
    text_left(context.px(14), 0.5f * bar.height, "steplab", colour::text);
}

}  // namespace

void draw_top_bar(const Context& context) {
    const Area& bar = context.layout.bar;
    ImGui::SetNextWindowPos({bar.x, bar.y});
    ImGui::SetNextWindowSize({bar.width, bar.height});
    ImGui::Begin("bar", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (context.layout.bar_has_title) draw_title(context);
    const float left = context.layout.bar_has_title ? context.px(312) : context.px(12);
    ImGui::SetCursorPos({left, std::round(0.5f * (bar.height - ImGui::GetFrameHeight()))});
    draw_transport(context);
    if (context.layout.bar_has_speed) {
        draw_speed(context);
        draw_rate(context);
    }
    draw_right_group(context);
    ImGui::PushClipRect({bar.x, bar.y}, {bar.right(), bar.bottom()}, false);
    ImGui::GetWindowDrawList()->AddLine({0, bar.height - 1}, {bar.width, bar.height - 1}, colour::line);
    ImGui::PopClipRect();
    ImGui::End();
}

}  // namespace steplab::ui
