#include "render/run_labels.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace steplab::render {
namespace {

// In pixels at scale 1.
constexpr double line_height = 20, outer_edge = 10, right_edge = 20, mark_radius = 5, number_place = 18,
                 name_place = 33, padding = 6;
constexpr double narrowest_with_both = 700;  // a picture with room for read-out and lines at its top
constexpr double cross_room = 104, narrowest_with_cross = 300;

/// The outline that the particles of a run have (shaders/ghost.frag); a filled disc for the leading run.
void sketch_mark(Sketch& sketch, PixelPoint centre, const RunLine::Run& run, Rgb colour, double pixel_scale) {
    const double r = mark_radius * pixel_scale, width = 1.6 * pixel_scale;
    if (run.number == 0) return sketch.disc(centre, r, colour);
    constexpr struct {
        int corners;
        double first, reach;
    } outlines[] = {{4, 0.25, 1.3}, {0, 0, 1}, {4, 0.375, 1.2}, {3, 0.25, 1.3}};
    const auto& [corners, first, reach] = outlines[run.swatch];
    sketch.outline(centre, reach * r, corners, first, colour, width);
}

/// `middle`: of its left end.
void sketch_line(Sketch& sketch, const RunLine& line, PixelPoint middle, const Palette& palette, double pixel_scale) {
    const double y = middle.y - sketch.text_size(line.text).y / 2;
    if (!line.run) return sketch.text({middle.x, y}, line.text, palette.text);
    sketch_mark(sketch, {middle.x + mark_radius * pixel_scale, middle.y}, *line.run, palette.runs[line.run->swatch],
                pixel_scale);
    sketch.text({middle.x + number_place * pixel_scale, y}, std::to_string(line.run->number), palette.text);
    sketch.text({middle.x + name_place * pixel_scale, y}, line.text, palette.text);
}

/// "differences \u00d7 1000"
std::string times(std::string_view what, double factor) {
    return fmt::format("{} \u00d7 {}", what, short_number(factor));
}

/// The text, or as much of its beginning as fits.
std::string cut_to(const Sketch& sketch, std::string text, double width) {
    if (sketch.text_size(text).x <= width) return text;
    const auto continues = [&] { return !text.empty() && (text.back() & 0xC0) == 0x80; };  // a byte within a letter
    while (!text.empty() && sketch.text_size(text + "...").x > width) {
        while (continues()) text.pop_back();
        if (!text.empty()) text.pop_back();
    }
    return text + "...";
}

}  // namespace

std::vector<RunLine> lines_of_runs(ShownRuns runs, const Style& style) {
    std::vector<RunLine> lines;
    for (std::size_t i = 0; i < runs.size() && runs.size() > 1 && style.legend; ++i)
        lines.push_back(line_of_run(runs[i], i));
    if (runs.size() > 1 && style.magnify != 1) lines.push_back({times("differences", style.magnify)});
    if (runs[0].frame->magnified != 1) lines.push_back({times("displacements", runs[0].frame->magnified)});
    return lines;
}

std::vector<RunLine> lines_of_tile(const ShownRun& run, std::size_t number) {
    std::vector<RunLine> lines{line_of_run(run, number)};
    if (run.frame->magnified != 1) lines.push_back({times("displacements", run.frame->magnified)});
    return lines;
}

std::size_t most_run_lines(std::size_t runs, const Style& style) {
    const std::size_t factor = style.displacements == 1 ? 0 : 1;
    if (runs == 1) return factor;
    return factor + (style.layout == RunLayout::split ? 1 : runs + (style.magnify == 1 ? 0 : 1));
}

RunLine line_of_run(const ShownRun& run, std::size_t number) { return {run.name, RunLine::Run{number, run.swatch}}; }

PictureArea run_lines_area(PictureSize picture, RunLayout layout, std::size_t lines, double pixel_scale) {
    const auto pixels = [&](double units) { return static_cast<int>(std::lround(units * pixel_scale)); };
    const int height = pixels(line_height * static_cast<double>(lines));
    const bool beside_read_out = layout == RunLayout::ghosts && picture.width >= pixels(narrowest_with_both);
    const bool beside_cross = picture.width >= pixels(narrowest_with_cross);
    const int left = pixels(beside_read_out ? read_out_room : beside_cross ? cross_room : padding);
    const int top = beside_read_out ? pixels(outer_edge) : picture.height - pixels(outer_edge) - height;
    return {left, top, {picture.width - left, height}};
}

PictureArea sketch_run_lines(Sketch& sketch, const std::vector<RunLine>& lines, const PictureArea& area,
                             const Palette& palette, double pixel_scale) {
    if (lines.empty()) return {0, 0, {0, 0}};
    const double edge = padding * pixel_scale;
    const double room = area.size.width - 2 * edge;
    std::vector<RunLine> shown = lines;
    double widest = 0;
    for (RunLine& line : shown) {
        const double indent = line.run ? name_place * pixel_scale : 0;
        line.text = cut_to(sketch, line.text, room - indent);
        widest = std::max(widest, indent + sketch.text_size(line.text).x);
    }
    const double end = area.left + area.size.width;
    const double right = std::max(end - right_edge * pixel_scale, std::min(area.left + edge + widest, end - edge));
    const double left = right - widest, step = line_height * pixel_scale;
    sketch.box({left - edge, static_cast<double>(area.top)},
               {right + edge, static_cast<double>(area.top + area.size.height)}, palette.bottom, veil);
    for (std::size_t i = 0; i < shown.size(); ++i)
        sketch_line(sketch, shown[i], {left, area.top + (static_cast<double>(i) + 0.5) * step}, palette, pixel_scale);
    const int begin = static_cast<int>(left - edge);
    return {begin, area.top, {area.left + area.size.width - begin, area.size.height}};
}

}  // namespace steplab::render
