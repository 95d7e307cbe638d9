#include "core/number_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"

#include <fmt/format.h>

#include <algorithm>
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
    const bool late = errors.time < view.frame.time - 1e-9;
    lines.push_back({fmt::format("position error: {} (against a reference{})", with_unit(rounded_text(lead.error), "m"),
                                 late ? fmt::format(", at t = {} s", typed(errors.time, 4)) : "")});
    if (lead.reference_error > 0.1 * lead.error)
        lines.push_back({"the reference is accurate to " + with_unit(rounded_text(lead.reference_error), "m") + " only",
                         colour::caution});
}

/// The error of the moment, and the digits that the largest one so far has left; or why they are not known.
void append_error(std::vector<Line>& lines, const Context& context) {
    const RunView& view = context.view;
    const History& history = context.state.history;
    const auto error = view.diagnostics.error;
    const auto& errors = context.session.errors;
    if (!error && errors && !errors->runs.empty() && errors->runs.front())
        return append_reference_error(lines, *errors, view);
    if (!error) {
        if (!view.why_not_exact.empty()) lines.push_back({"position error unknown: " + view.why_not_exact});
        return;
    }
    lines.push_back({"position error: " + with_unit(rounded_text(*error), "m") + " (against the exact solution)"});
    const double scale = std::max(history.largest_displacement(), view.diagnostics.max_displacement);
    const double worst = std::max(history.largest_error(), *error);
    const auto digits = correct_digits(worst, scale, view.description.precision);
    if (digits) lines.push_back({digits_text(*digits), *digits < 1 ? colour::bad : colour::good});
}

/// Of several selected particles.
void append_selection(std::vector<Line>& lines, const Context& context) {
    if (context.state.selection.others().empty()) return;
    const std::vector<std::size_t> particles = context.state.selection.all(context.view);
    const Middle middle = middle_of(context.view, particles);
    lines.push_back({fmt::format("{} particles selected", particles.size()), colour::text});
    lines.push_back({fmt::format("centre of mass: {} m", vector(middle.position))});
    lines.push_back({fmt::format("mean velocity: {} m/s", vector(middle.velocity))});
}

std::vector<Line> lines_of(const Context& context) {
    const RunView& view = context.view;
    std::vector<Line> lines;
    lines.push_back(
        {fmt::format("t = {} s   step {}", time_text(view.frame.time, view.dt), view.frame.step), colour::text, true});
    const std::string energy = has_drag(view.description) ? "energy change: " : "energy error: ";
    lines.push_back({energy + with_unit(rounded_text(view.diagnostics.energy_error), "J")});
    if (view.baseline_step > 0) lines.push_back({fmt::format("relative to the energy at step {}", view.baseline_step)});
    append_error(lines, context);
    if (!view.frame.ensemble.empty())
        lines.push_back({"ensemble spread: max " + with_unit(rounded_text(view.ensemble_spread.largest), "m")});
    append_selection(lines, context);
    std::erase_if(lines, [](const Line& line) { return line.text.empty(); });
    return lines;
}

}  // namespace

void draw_read_out(const Context& context) {
    const Area& scene = context.layout.scene;
    auto lines = lines_of(context);
    const auto font_of = [&](const Line& line) {
        return line.strong ? context.theme.fonts().strong : context.theme.fonts().small;
    };
    const bool small = scene.width < context.px(300) || scene.height < context.px(200);
    if (small) lines.resize(1);
    const float padding = context.px(11);
    const float gap = context.px(3);
    float width = 0;
    float height = 2 * padding - gap;
    for (const Line& line : lines) {
        const ImFont* font = font_of(line);
        width = std::max(width, font->CalcTextSizeA(font->FontSize, 1e9f, 0, line.text.c_str()).x);
        height += font->FontSize + gap;
    }
    const ImVec2 corner{scene.x + context.px(small ? 6 : 16), scene.y + context.px(small ? 6 : 14)};
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(corner, {corner.x + width + 2 * padding, corner.y + height}, colour::card, context.px(6));
    float y = corner.y + padding;
    for (const Line& line : lines) {
        ImFont* font = font_of(line);
        list.AddText(font, font->FontSize, {corner.x + padding, y}, line.ink, line.text.c_str());
        y += font->FontSize + gap;
    }
}

}  // namespace steplab::ui
