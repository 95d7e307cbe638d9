#include "core/number_text.hpp"
#include "core/terms.hpp"
#include "render/run_labels.hpp"
#include "ui/panels/late_errors.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cfloat>
#include <cstddef>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

struct Line {
    std::string text;
    ImU32 ink = colour::text_dim;
    bool strong = false;
};

/// Against a reference run, while that tells it.
void append_reference_error(std::vector<Line>& lines, const SessionErrors& errors, const RunView& view) {
    const Compared& lead = *errors.runs.front();
    const bool late = are_late(errors, view);
    lines.push_back({fmt::format("position error: {} (against a reference{})", with_unit(error_text(lead.error), "m"),
                                 late ? fmt::format(", at t = {} s", typed(errors.time, 4)) : "")});
    const double rounding = 1e-13 * view.frame.shape->spacing;  // more accurate than that is accurate enough
    if (lead.reference_error > std::max(rounding, 0.1 * lead.error))
        lines.push_back({"the reference is accurate to " + with_unit(error_text(lead.reference_error), "m") + " only",
                         colour::caution});
}

/// The error of the moment, and the digits that the largest one so far has left; or why they are not known.
void append_error(std::vector<Line>& lines, const Context& context) {
    const RunView& view = context.pictured.leading;
    const History& history = context.state.history;
    const auto error = view.diagnostics.error;
    const auto& errors = context.pictured.errors;
    if (!error && errors && !errors->runs.empty() && errors->runs.front())
        return append_reference_error(lines, *errors, view);
    if (!error) {
        if (!view.why_not_exact.empty() && !view.divergence)
            lines.push_back({"position error unknown: " + view.why_not_exact});
        return;
    }
    lines.push_back({"position error: " + with_unit(error_text(*error), "m") + " (against the exact solution)"});
    const double scale = std::max(history.largest_displacement(), view.diagnostics.max_displacement);
    const double worst = std::max(history.largest_error(), *error);
    const auto digits = correct_digits(worst, scale, view.description.precision);
    if (digits) lines.push_back({digits_text(*digits), *digits < 1 ? colour::bad : colour::good});
}

/// Of several selected particles.
void append_selection(std::vector<Line>& lines, const Context& context) {
    if (context.state.selection.others().empty()) return;
    const std::vector<std::size_t> particles = context.state.selection.all(context.pictured.leading);
    const Middle middle = middle_of(context.pictured.leading, particles);
    lines.push_back({fmt::format("{} particles selected", particles.size()), colour::text});
    lines.push_back({fmt::format("centre of mass: {} m", vector(middle.position))});
    lines.push_back({fmt::format("mean velocity: {} m/s", vector(middle.velocity))});
}

std::vector<Line> lines_of(const Context& context) {
    const RunView& view = context.pictured.leading;
    std::vector<Line> lines;
    lines.push_back(
        {fmt::format("t = {} s   step {}", time_text(view.frame.time, view.dt), view.frame.step), colour::text, true});
    if (context.session.playback && !context.session.playback->measured) return lines;
    const std::string energy = view.facts.drag > 0 ? "energy change: " : "energy error: ";
    lines.push_back({energy + with_unit(error_text(view.diagnostics.energy_error), "J")});
    if (view.baseline_step > 0) lines.push_back({fmt::format("relative to the energy at step {}", view.baseline_step)});
    append_error(lines, context);
    if (!view.frame.ensemble.empty())
        lines.push_back({"ensemble spread: max " + with_unit(error_text(view.ensemble_spread.largest), "m")});
    for (const std::string& note : view.notes) lines.push_back({note, colour::caution});
    append_selection(lines, context);
    std::erase_if(lines, [](const Line& line) { return line.text.empty(); });
    return lines;
}

ImFont* font_of(const Context& context, const Line& line) {
    return line.strong ? context.theme.fonts().strong : context.theme.fonts().small;
}

/// The part of the scene that the read-out may take: the tile of the leading run, but for the lines about the runs.
Area room_for_read_out(const Context& context) {
    const auto [x, y, width, height] = context.tile();
    Area room{static_cast<float>(x), static_cast<float>(y), static_cast<float>(width), static_cast<float>(height)};
    const render::Style& style = context.stage.style;
    const std::size_t lines = render::most_run_lines(1 + context.session.followers.size(), style);
    if (lines == 0) return room;
    const auto taken = render::run_lines_area({width, height}, style.layout, lines, style.pixel_scale);
    if (2 * taken.top > height) {
        room.height = static_cast<float>(taken.top);
    } else {
        room.width = static_cast<float>(taken.left);
    }
    return room;
}

/// A line where it is drawn, in pixels from the top left of all of them.
struct Place {
    float y = 0, width = 0, height = 0;
};

/// As many lines as fit, the first one in any case; longer ones are wrapped.
std::vector<Place> places_of(const Context& context, const std::vector<Line>& lines, float width, float height) {
    std::vector<Place> places;
    float y = 0;
    for (const Line& line : lines) {
        const ImFont* const font = font_of(context, line);
        const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, width, line.text.c_str());
        if (!places.empty() && y + size.y > height) break;
        places.push_back({y, size.x, size.y});
        y += size.y + context.px(3);
    }
    return places;
}

}  // namespace

void draw_read_out(const Context& context) {
    const Area room = room_for_read_out(context);
    auto lines = lines_of(context);
    const bool small = room.width < context.px(300) || room.height < context.px(110);
    if (small) lines.resize(1);
    const float padding = context.px(small ? 6 : 11), margin = context.px(small ? 4 : 14);
    const ImVec2 corner{room.x + context.px(small ? 4 : 16), room.y + margin};
    const float width = std::min(room.right() - corner.x - 2 * padding - context.px(4), context.px(380));
    const auto places = places_of(context, lines, width, room.height - margin - 2 * padding - context.px(4));
    float widest = 0;
    for (const Place& place : places) widest = std::max(widest, place.width);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(
        corner, {corner.x + widest + 2 * padding, corner.y + places.back().y + places.back().height + 2 * padding},
        colour::card, context.px(6));
    for (std::size_t i = 0; i < places.size(); ++i) {
        ImFont* const font = font_of(context, lines[i]);
        list.AddText(font, font->FontSize, {corner.x + padding, corner.y + padding + places[i].y}, lines[i].ink,
                     lines[i].text.c_str(), nullptr, width);
        const float top = corner.y + padding + places[i].y;
        tooltip_in_scene(context, {corner.x, top, corner.x + widest + 2 * padding, top + places[i].height},
                         explanations(lines[i].text));
    }
}

}  // namespace steplab::ui
