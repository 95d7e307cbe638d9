#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "ui/actions.hpp"
#include "ui/hands.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/parameter_rows.hpp"
#include "ui/widgets/slider.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

using Particles = std::vector<std::size_t>;

/// As long as the run has not taken a change, what was asked for.
Alteration asked_of(const Context& context, std::size_t particle) {
    return context.description().alterations.of(particle);
}

double asked_mass(const Context& context, std::size_t particle) {
    return asked_of(context, particle).mass.value_or(mass_of(context.view, particle));
}

bool asked_fixed(const Context& context, std::size_t particle) {
    const bool now = context.view.frame.shape->roles[particle] == Role::fixed;
    return asked_of(context, particle).fixed.value_or(now);
}

/// True if a value is not the same of all particles.
template <class Value>
bool differs(const Particles& particles, const Value& value) {
    return std::any_of(particles.begin(), particles.end(),
                       [&](std::size_t particle) { return value(particle) != value(particles.front()); });
}

void alter(const Context& context, const Particles& particles, Alteration how) {
    std::vector<Alteration> all;
    for (const std::size_t particle : particles) {
        how.particle = particle;
        all.push_back(how);
    }
    context.ask(with_alterations(context.description(), all));
}

void draw_mass(const Context& context, const Particles& particles) {
    const auto mass_now = [&](std::size_t particle) { return asked_mass(context, particle); };
    const double mass = mass_now(particles.front());
    if (!(mass > 0)) return;
    const bool mixed = differs(particles, mass_now);
    const auto set = [&](double value) { alter(context, particles, {.mass = value}); };
    ParameterInfo info = altered_mass;
    info.default_value = usual_mass(context.view, mass);
    const std::string help = parameter_help(info);
    slider_row(context, {
                            .widget = "selection.mass",
                            .label = info.name,
                            .tooltip = help,
                            .value_text = mixed ? "mixed" : with_unit(setting_text(mass), info.unit),
                            .entry_text = mixed ? "" : format_value(info, mass),
                            .value = mass,
                            .default_value = info.default_value,
                            .range = {info.slider_low, info.slider_high, info.slider_logarithmic, false},
                            .style = {.fill = mixed ? colour::track : colour::accent},
                            .set = set,
                            .set_text = [&](std::string_view typed) { set(parse_value(info, typed)); },
                        });
}

void draw_fixed(const Context& context, const Particles& particles) {
    const auto fixed_now = [&](std::size_t particle) { return asked_fixed(context, particle); };
    bool on = fixed_now(particles.front());
    if (check_row(context, "selection.fixed", "fixed", on, differs(particles, fixed_now)))
        alter(context, particles, {.fixed = on});
    tooltip(context, "hold the selected particles where they are; the run continues");
}

/// "0, 0.5, 0" Throws UsageError.
Vec3 parse_velocity(std::string_view text) {
    std::array<double, 3> parts{};
    std::string_view rest = text;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t comma = i + 1 < parts.size() ? rest.find(',') : rest.size();
        std::string_view part = rest.substr(0, comma);
        while (part.starts_with(' ')) part.remove_prefix(1);
        while (part.ends_with(' ')) part.remove_suffix(1);
        const auto number = parse_number(part);
        if (comma == std::string_view::npos || !number)
            throw UsageError(fmt::format("'{}' is no velocity: three numbers in m/s, such as 0, 0.5, 0", shown(text)));
        parts[i] = *number;
        rest.remove_prefix(std::min(rest.size(), comma + 1));
    }
    return {parts[0], parts[1], parts[2]};
}

void draw_kick(const Context& context, const Particles& particles) {
    Hands& hands = context.state.hands;
    const RowPlaces places = row_places(context);
    const float button = places.right - places.value;
    row_label(context, "velocity", "in m/s, three numbers: what a kick adds to that of each selected particle",
              ImGui::GetFrameHeight());
    ImGui::SameLine(places.control);
    ImGui::SetNextItemWidth(places.value - places.control - context.px(6));
    const bool entered = ImGui::InputText("##velocity", hands.velocity.data(), hands.velocity.size(),
                                          ImGuiInputTextFlags_EnterReturnsTrue);
    context.mark("selection.velocity");
    ImGui::SameLine(places.value);
    const bool clicked = text_button(context, "selection.kick", "Kick", false, button);
    if (!entered && !clicked) return;
    const auto& roles = context.view.frame.shape->roles;
    const auto moving = std::find_if(particles.begin(), particles.end(),
                                     [&](std::size_t particle) { return roles[particle] != Role::fixed; });
    if (moving == particles.end()) return context.state.wanted.refuse("a fixed particle cannot be kicked");
    try {
        kick(context, *moving, parse_velocity(hands.velocity.data()));
    } catch (const UsageError& error) {
        context.state.wanted.refuse(error.what());
    }
}

void draw_select_box(const Context& context) {
    Hands& hands = context.state.hands;
    if (text_button(context, "selection.box", hands.selecting ? "Drag a box in the scene" : "Select a box",
                    hands.selecting))
        perform(context, Action::select_box);
    tooltip(context, help_of(Action::select_box));
}

}  // namespace

void draw_selection_panel(const Context& context) {
    const Particles particles = context.state.selection.all(context.view);
    heading(context, "SELECTION");
    if (particles.empty()) return draw_select_box(context);
    reading_row(context, "selected",
                particles.size() == 1 ? fmt::format("particle {}", particles.front())
                                      : fmt::format("{} particles", particles.size()));
    draw_mass(context, particles);
    draw_fixed(context, particles);
    draw_kick(context, particles);
    draw_select_box(context);
}

}  // namespace steplab::ui
