#include "render/run_labels.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplab::render {
namespace {

// In pixels at scale 1.
constexpr double line_height = 20, top_edge = 10, right_edge = 20, mark_radius = 5, gap = 9, padding = 6;
constexpr double veil = 0.72;  // opacity of the ground of a text

/// The outline that the particles of a run have (shaders/ghost.frag); a filled disc for the leading run.
void sketch_mark(Sketch& sketch, PixelPoint centre, std::size_t run, Rgb colour, double pixel_scale) {
    const double r = mark_radius * pixel_scale, width = 1.6 * pixel_scale;
    if (run == 0) return sketch.disc(centre, r, colour);
    constexpr int corners[] = {0, 0, 4, 3};
    constexpr double reach[] = {1, 1, 1.2, 1.3};
    sketch.outline(centre, reach[run] * r, corners[run], colour, width);
}

}  // namespace

std::vector<RunLine> lines_of_ghosts(ShownRuns runs, const Style& style) {
    std::vector<RunLine> lines;
    for (std::size_t i = 0; i < runs.size() && style.legend; ++i) lines.push_back(line_of_run(runs[i], i));
    if (style.magnify != 1) lines.push_back({fmt::format("differences \u00d7 {}", typed(style.magnify, 4))});
    return lines;
}

RunLine line_of_run(const ShownRun& run, std::size_t number) {
    return {fmt::format("{}   {}", number, run.name), number};
}

double sketch_run_lines(Sketch& sketch, const std::vector<RunLine>& lines, PictureSize size, const Palette& palette,
                        double pixel_scale) {
    if (lines.empty()) return 0;
    double widest = 0;
    for (const RunLine& line : lines) widest = std::max(widest, sketch.text_size(line.text).x);
    const double mark = (2 * mark_radius + gap) * pixel_scale, edge = padding * pixel_scale;
    const double right = size.width - right_edge * pixel_scale, top = top_edge * pixel_scale;
    // A name too long for the picture is cut off at its end.
    const double left = std::max(right - widest - mark, 2 * edge), step = line_height * pixel_scale;
    const double height = step * static_cast<double>(lines.size());
    sketch.box({left - edge, top}, {right + edge, top + height}, palette.bottom, veil);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double middle = top + (static_cast<double>(i) + 0.5) * step;
        const auto& [text, run] = lines[i];
        sketch.text({left + mark, middle - sketch.text_size(text).y / 2}, text, palette.text);
        if (run) sketch_mark(sketch, {left + mark_radius * pixel_scale, middle}, *run, palette.runs[*run], pixel_scale);
    }
    return height;
}

}  // namespace steplab::render
