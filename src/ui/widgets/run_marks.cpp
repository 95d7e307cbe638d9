#include "ui/widgets/run_marks.hpp"

#include "plot/plot.hpp"
#include "render/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace steplab::ui {

ImU32 run_ink(render::Background theme, std::size_t swatch) {
    const auto& colours = render::palette(theme).runs;
    const render::Rgb colour = colours[std::min(swatch, colours.size() - 1)];
    return IM_COL32(colour.red, colour.green, colour.blue, 255);
}

void draw_run_line(ImDrawList& list, ImVec2 from, float width, std::size_t swatch, ImU32 ink, float thickness) {
    const ImVec2 to{from.x + width, from.y};
    const std::span<const float> dashes = plot::dashes_of(plot::line_of_run(swatch));
    if (dashes.empty()) return list.AddLine(from, to, ink, thickness);
    draw_dashes(list, std::array{from, to}, dashes, ink, thickness);
}

void draw_dashes(ImDrawList& list, std::span<const ImVec2> points, std::span<const float> dashes, ImU32 ink,
                 float thickness) {
    const double period = std::accumulate(dashes.begin(), dashes.end(), 0.0) * static_cast<double>(thickness);
    if (!(period > 0)) return;
    // where a dash or gap begins along the line, counted through: no length is left over by rounding
    const auto begin_of = [&](std::size_t dash) {
        const std::size_t part = dash % dashes.size(), whole = dash / dashes.size();
        const double before = std::accumulate(dashes.begin(), dashes.begin() + static_cast<std::ptrdiff_t>(part), 0.0);
        return static_cast<double>(whole) * period + before * static_cast<double>(thickness);
    };
    double behind = 0;  // of the line, before the piece
    std::size_t dash = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const ImVec2 a = points[i - 1], b = points[i];
        const double piece = std::hypot(b.x - a.x, b.y - a.y);
        const auto at = [&](double along) {
            const auto part = static_cast<float>(std::clamp((along - behind) / piece, 0.0, 1.0));
            return ImVec2(a.x + (b.x - a.x) * part, a.y + (b.y - a.y) * part);
        };
        for (; piece > 0 && begin_of(dash) < behind + piece; ++dash) {
            if (dash % 2 == 0) list.AddLine(at(begin_of(dash)), at(begin_of(dash + 1)), ink, thickness);
            if (begin_of(dash + 1) > behind + piece) break;  // it goes on in the next piece
        }
        behind += piece;
    }
}

}  // namespace steplab::ui
