#include "render/run_labels.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplab::render {
namespace {

// In pixels at scale 1.
constexpr double line_height = 20, outer_edge = 10, right_edge = 20, mark_radius = 5, number_place = 18,
                 name_place = 33, padding = 6;
constexpr double veil = 0.9;  // opacity of the ground of a text

/// The outline that the particles of a run have (shaders/ghost.frag); a filled disc for the leading run.
void sketch_mark(Sketch& sketch, PixelPoint centre, std::size_t run, Rgb colour, double pixel_scale) {
    const double r = mark_radius * pixel_scale, width = 1.6 * pixel_scale;
    if (run == 0) return sketch.disc(centre, r, colour);
    constexpr int corners[] = {0, 0, 4, 3};
    constexpr double reach[] = {1, 1, 1.2, 1.3};
    sketch.outline(centre, reach[run] * r, corners[run], colour, width);
}

/// `middle`: of its left end.
void sketch_line(Sketch& sketch, const RunLine& line, PixelPoint middle, const Palette& palette, double pixel_scale) {
    const double y = middle.y - sketch.text_size(line.text).y / 2;
    if (!line.run) return sketch.text({middle.x, y}, line.text, palette.text);
    sketch_mark(sketch, {middle.x + mark_radius * pixel_scale, middle.y}, *line.run, palette.runs[*line.run],
                pixel_scale);
    sketch.text({middle.x + number_place * pixel_scale, y}, std::to_string(*line.run), palette.text);
    sketch.text({middle.x + name_place * pixel_scale, y}, line.text, palette.text);
}

}  // namespace

std::vector<RunLine> lines_of_ghosts(ShownRuns runs, const Style& style) {
    std::vector<RunLine> lines;
    for (std::size_t i = 0; i < runs.size() && style.legend; ++i) lines.push_back(line_of_run(runs[i], i));
    if (style.magnify != 1) lines.push_back({fmt::format("differences \u00d7 {}", short_number(style.magnify))});
    return lines;
}

RunLine line_of_run(const ShownRun& run, std::size_t number) { return {run.name, number}; }

double sketch_run_lines(Sketch& sketch, const std::vector<RunLine>& lines, RunLinesAt place, PictureSize size,
                        const Palette& palette, double pixel_scale) {
    if (lines.empty()) return 0;
    double widest = 0;
    for (const RunLine& line : lines) {
        const double indent = line.run ? name_place * pixel_scale : 0;
        widest = std::max(widest, indent + sketch.text_size(line.text).x);
    }
    const double edge = padding * pixel_scale, margin = outer_edge * pixel_scale;
    const double right = size.width - right_edge * pixel_scale;
    // A name too long for the picture is cut off at its end.
    const double left = std::max(right - widest, 2 * edge), step = line_height * pixel_scale;
    const double height = step * static_cast<double>(lines.size());
    const double top = place == RunLinesAt::top ? margin : size.height - margin - height;
    sketch.box({left - edge, top}, {right + edge, top + height}, palette.bottom, veil);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double middle = top + (static_cast<double>(i) + 0.5) * step;
        sketch_line(sketch, lines[i], {left, middle}, palette, pixel_scale);
    }
    return place == RunLinesAt::top ? height : 0;
}

}  // namespace steplab::render
