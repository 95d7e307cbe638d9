#include "ui/plot/plot_lines.hpp"

#include "ui/plot/draw_plot.hpp"
#include "ui/widgets/run_marks.hpp"

#include <algorithm>

namespace steplab::ui {
namespace {

void draw_solid(ImDrawList& list, const std::vector<ImVec2>& corners, ImU32 ink, float thickness) {
    // ImGui's indices have 16 bits; a thick line takes up to 6 vertices per point.
    constexpr std::size_t most = 8192;
    for (std::size_t from = 0; from + 1 < corners.size(); from += most - 1) {
        const std::size_t count = std::min(most, corners.size() - from);
        list.AddPolyline(corners.data() + from, static_cast<int>(count), ink, 0, thickness);
    }
}

}  // namespace

float thickness_of(const Context& context) { return context.theme.scale() * 1.6f; }

void draw_line(ImDrawList& list, const std::vector<ImVec2>& corners, plot::Line line, ImU32 ink, float thickness) {
    if (line == plot::Line::none) return;
    if (line == plot::Line::solid) return draw_solid(list, corners, ink, thickness);
    draw_dashes(list, corners, plot::dashes_of(line), ink, thickness);
}

void draw_marks(ImDrawList& list, const std::vector<ImVec2>& corners, ImU32 ink, float radius) {
    for (const ImVec2& corner : corners) list.AddCircleFilled(corner, radius, ink);
}

ImU32 area_ink(const Context& context, const plot::Band& band) {
    constexpr ImU32 alpha = 0x38;
    return (ink_of(context, band.colour) & ~IM_COL32_A_MASK) | alpha << IM_COL32_A_SHIFT;
}

}  // namespace steplab::ui
