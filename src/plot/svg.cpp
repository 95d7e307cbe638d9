#include "plot/svg.hpp"

#include "core/markup.hpp"
#include "plot/layout.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace steplab::plot {
namespace {

constexpr float width = 720, height = 440, font_height = 12;
constexpr std::string_view ink = "#1b2430", dim = "#5b6675", grid = "#dfe4ea";

/// Of runs: dark enough on white, and told apart by those who see no red or green (Okabe, Ito 2008).
std::string_view colour_of(std::size_t colour) {
    constexpr std::array runs{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"};
    if (colour == Curve::exact) return "#1b2430";
    if (colour == Curve::quiet) return "#9aa5b1";
    return runs[colour % runs.size()];
}

std::string text_at(float x, float y, std::string_view anchor, std::string_view colour, std::string_view text,
                    std::string_view more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n", x, y, anchor,
                       colour, more, escaped(text));
}

std::string line_between(float x0, float y0, float x1, float y1, std::string_view colour, float thickness = 1) {
    return fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{:.1f}\"/>\n", x0,
        y0, x1, y1, colour, thickness);
}

std::string dashes(Line line, float thickness) {
    std::string lengths;
    for (const float length : dashes_of(line)) lengths += fmt::format("{:.1f} ", length * thickness);
    return lengths.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", lengths.substr(0, lengths.size() - 1));
}

std::string ticks_of(const Layout& layout) {
    const Box& frame = layout.frame;
    std::string text;
    for (const PlacedTick& tick : layout.up) {
        text += line_between(frame.x, tick.pixel, frame.right(), tick.pixel, grid);
        text += text_at(tick.place.right(), tick.pixel + 4, "end", ink, tick.label);
    }
    for (const PlacedTick& tick : layout.across) {
        text += line_between(tick.pixel, frame.y, tick.pixel, frame.bottom(), grid);
        text += text_at(tick.place.x + 0.5f * tick.place.width, frame.bottom() + 17, "middle", ink, tick.label);
    }
    return text;
}

std::string path_of(const Curve& curve, const Axes& axes) {
    constexpr float thickness = 1.6f;
    std::string points, dots;
    const auto shown = decimated(curve.x, curve.y, axes);
    for (const Point& point : shown) {
        points += fmt::format("{:.2f},{:.2f} ", point.x, point.y);
        if (curve.marks || shown.size() < 40)
            dots += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"2.4\"/>", point.x, point.y);
    }
    const std::string_view colour = colour_of(curve.colour);
    return fmt::format(
        "<g stroke=\"{0}\" fill=\"{0}\"><title>{1}</title><polyline fill=\"none\" stroke-width=\"{2:.1f}\"{3} "
        "stroke-linejoin=\"round\" points=\"{4}\"/>{5}</g>\n",
        colour, escaped(curve.name), thickness, dashes(curve.line, thickness), points, dots);
}

std::string moments_of(const Plot& plot, const Layout& layout) {
    std::string text;
    for (const Moment& moment : plot.moments) {
        const float x = layout.axes.across.pixel(moment.x);
        text += line_between(x, layout.frame.y, x, layout.frame.bottom(), "#9aa5b1");
        text += text_at(x + 3, layout.frame.bottom() - 4, "start", dim, moment.text, " font-size=\"10\"");
    }
    return text;
}

/// One below the other in the right upper corner.
std::string legend_of(const Plot& plot, const Layout& layout) {
    if (plot.curves.size() < 2) return {};
    std::string text;
    float y = layout.frame.y + 14;
    const float right = layout.frame.right() - 8;
    for (const Curve& curve : plot.curves) {
        text += fmt::format(
            "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"1.6\"{}/>\n",
            right - 24, y - 4, right, y - 4, colour_of(curve.colour), dashes(curve.line, 1.6f));
        text += text_at(right - 30, y, "end", ink, curve.name);
        y += 16;
    }
    return text;
}

std::string frame_of(const Box& frame) {
    return fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" stroke=\"{}\"/>\n", frame.x,
        frame.y, frame.width, frame.height, dim);
}

}  // namespace

std::string svg(const Plot& plot) {
    const Lettering lettering{
        [](const std::string& text) { return 0.58f * font_height * static_cast<float>(text.size()); }, font_height, 1};
    const Layout layout = layout_of(plot, {0, 0, width, height - 18}, lettering);
    const Box& frame = layout.frame;
    const std::string across = plot.x.unit.empty() ? plot.x.name : fmt::format("{} [{}]", plot.x.name, plot.x.unit);
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\" font-size=\"{2}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n"
        "<clipPath id=\"frame\"><rect x=\"{3:.1f}\" y=\"{4:.1f}\" width=\"{5:.1f}\" height=\"{6:.1f}\"/></clipPath>\n",
        width, height, font_height, frame.x, frame.y, frame.width, frame.height);
    text += text_at(14, 22, "start", ink, plot.title, " font-size=\"14\" font-weight=\"bold\"");
    text += ticks_of(layout) + frame_of(frame) + "<g clip-path=\"url(#frame)\">\n" + moments_of(plot, layout);
    for (const Curve& curve : plot.curves) text += path_of(curve, layout.axes);
    text += "</g>\n" + legend_of(plot, layout);
    text += text_at(frame.x + 0.5f * frame.width, frame.bottom() + 36, "middle", dim, across);
    text += text_at(14, height - 8, "start", dim, plot.caption, " font-size=\"10\"");
    return text + "</svg>\n";
}

}  // namespace steplab::plot
