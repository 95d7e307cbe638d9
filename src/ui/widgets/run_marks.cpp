#include "ui/widgets/run_marks.hpp"

#include "render/palette.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace steplab::ui {

namespace {

/// Lengths of dash and gap in turn, in thicknesses of the line; empty: solid.
std::span<const float> dashes_of(std::size_t run) {
    static constexpr std::array dashed{4.0f, 2.5f}, dotted{1.2f, 1.8f};
    static constexpr std::array both{4.5f, 1.8f, 1.2f, 1.8f};
    switch (run) {
        case 1:
            return dashed;
        case 2:
            return dotted;
        case 3:
            return both;
        default:
            return {};
    }
}

}  // namespace

ImU32 run_ink(render::Background theme, std::size_t run) {
    const auto& colours = render::palette(theme).runs;
    const render::Rgb colour = colours[std::min(run, colours.size() - 1)];
    return IM_COL32(colour.red, colour.green, colour.blue, 255);
}

void draw_run_line(ImDrawList& list, ImVec2 from, float width, std::size_t run, ImU32 ink, float thickness) {
    const std::span<const float> dashes = dashes_of(run);
    if (dashes.empty()) return list.AddLine(from, {from.x + width, from.y}, ink, thickness);
    const float end = from.x + width;
    std::size_t part = 0;
    for (float x = from.x; x < end; ++part) {
        const float next = x + dashes[part % dashes.size()] * thickness;
        if (part % 2 == 0) list.AddLine({x, from.y}, {std::min(next, end), from.y}, ink, thickness);
        x = next;
    }
}

}  // namespace steplab::ui
