#include "plot/svg.hpp"

#include "core/markup.hpp"
#include "plot/curve_names.hpp"
#include "plot/free_corner.hpp"
#include "plot/layout.hpp"
#include "plot/moment_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace steplab::plot {
namespace {

constexpr float font_height = 12, small_height = 10;

/// Of runs: dark enough on white, and told apart by those who see no red or green (Okabe, Ito 2008).
Inks inks_on_white() {
    return {.paper = "#ffffff",
            .text = "#1b2430",
            .dim = "#5b6675",
            .grid = "#dfe4ea",
            .exact = "#1b2430",
            .quiet = "#9aa5b1",
            .curves = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"}};
}

float width_of(const std::string& text, float height = font_height) {
    const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
    return 0.58f * height * static_cast<float>(std::count_if(text.begin(), text.end(), begins));
}

Lettering lettering(float height = font_height) {
    return {[height](const std::string& text) { return width_of(text, height); }, height, 1};
}

std::string text_at(float x, float y, std::string_view anchor, std::string_view colour, std::string_view text,
                    std::string_view more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n", x, y, anchor,
                       colour, more, escaped(text));
}

std::string line_between(float x0, float y0, float x1, float y1, std::string_view colour, std::string_view more = "") {
    return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"{}/>\n", x0, y0, x1,
                       y1, colour, more);
}

std::string stroke_of(const Curve& curve) {
    if (curve.line == Line::none) return " stroke-width=\"0\"";
    const float thickness = curve.colour == Curve::quiet ? 0.9f : 1.6f;
    std::string lengths;
    for (const float length : dashes_of(curve.line)) lengths += fmt::format("{:.1f} ", length * thickness);
    std::string stroke = fmt::format(" stroke-width=\"{:.1f}\"", thickness);
    if (!lengths.empty()) stroke += fmt::format(" stroke-dasharray=\"{}\"", lengths.substr(0, lengths.size() - 1));
    return stroke;
}

/// Writes the parts of a picture.
class Drawing {
public:
    Drawing(const Plot& plot, const Inks& inks, float width, float height, float below)
        : plot_(plot),
          inks_(inks),
          width_(width),
          height_(height),
          layout_(layout_of(plot, {0, 0, width, height - below}, lettering())),
          moments_(moment_lines(plot, layout_, lettering(small_height))) {}

    /// All but texts about the curves, with the end left open.
    std::string content() const {
        const Box& frame = layout_.frame;
        std::string text = fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
            "font-family=\"sans-serif\" font-size=\"{2}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"{3}\"/>\n",
            width_, height_, font_height, inks_.paper);
        text += ticks() + border() + in_frame();
        return text + text_at(frame.x + 0.5f * frame.width, frame.bottom() + 36, "middle", inks_.dim, text_of(plot_.x));
    }

    std::string title(std::string_view more) const {
        return text_at(14, 22, "start", inks_.text, plot_.title.empty() ? text_of(plot_.y) : plot_.title, more);
    }

    std::string caption() const {
        return text_at(14, height_ - 8, "start", inks_.dim, plot_.caption, " font-size=\"10\"");
    }

    /// One below the other on a card in the corner where it covers least.
    std::string legend() const {
        if (plot_.curves.size() + plot_.bands.size() < 2) return {};
        const Box card = legend_card();
        const float right = card.right() - 4;
        float y = card.y + 13;
        std::string text = fmt::format(
            "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" fill-opacity=\"0.8\"/>\n",
            card.x, card.y, card.width, card.height, inks_.paper);
        const auto add = [&](const std::string& name, const std::string& sample) {
            text += sample + text_at(right - 30, y, "end", inks_.text, name);
            y += 16;
        };
        for (const Curve& curve : plot_.curves) {
            if (curve.in_legend) add(curve.legend(), sample_of(curve, right, y));
        }
        for (const Band& band : plot_.bands) add(band.name, sample_of(band, right, y));
        return text;
    }

    std::string names() const {
        std::string text;
        for (const CurveName& name : curve_names(plot_, layout_, lettering()))
            text += text_at(name.place.x + 2, name.place.bottom() - 3, "start", ink_of(name.colour), name.text, halo());
        return text;
    }

private:
    /// Sets a text off from the lines that it lies over.
    std::string halo() const {
        return fmt::format(" stroke=\"{}\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
                           inks_.paper);
    }

    Box legend_card() const {
        Box card{.width = 0, .height = 2};
        const auto add = [&](const std::string& name) {
            card.width = std::max(card.width, width_of(name) + 38);
            card.height += 16;
        };
        std::vector<std::vector<Point>> lines;
        for (const Curve& curve : plot_.curves) {
            if (curve.in_legend) add(curve.legend());
            lines.push_back(decimated(curve.x, curve.y, layout_.axes));
        }
        for (const Band& band : plot_.bands) add(band.name);
        const float above = 2 + height_of_labels(moments_, layout_.frame);
        const Box frame{layout_.frame.x + 3, layout_.frame.y + 2, layout_.frame.width - 6, layout_.frame.height - 3};
        const Corner corner = free_corner(lines, frame, card, above, Corner::top_right, 0);
        return card_in(frame, corner, card.width, card.height, above);
    }

    const std::string& ink_of(std::size_t colour) const {
        if (colour == Curve::exact) return inks_.exact;
        if (colour == Curve::quiet) return inks_.quiet;
        return inks_.curves[colour % inks_.curves.size()];
    }

    std::string sample_of(const Curve& curve, float right, float y) const {
        if (curve.line == Line::none)
            return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.2\" fill=\"{}\"/>\n", right - 12, y - 4,
                               ink_of(curve.colour));
        return line_between(right - 24, y - 4, right, y - 4, ink_of(curve.colour), stroke_of(curve));
    }

    std::string sample_of(const Band& band, float right, float y) const {
        return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"24\" height=\"8\" {}/>\n", right - 24, y - 8,
                           area_of(band));
    }

    std::string area_of(const Band& band) const {
        return fmt::format("fill=\"{}\" fill-opacity=\"0.22\" stroke=\"none\"", ink_of(band.colour));
    }

    std::string ticks() const {
        const Box& frame = layout_.frame;
        std::string text;
        for (const PlacedTick& tick : layout_.up) {
            text += line_between(frame.x, tick.pixel, frame.right(), tick.pixel, inks_.grid);
            text += line_between(frame.x - tick_length, tick.pixel, frame.x, tick.pixel, inks_.quiet);
            text += text_at(tick.place.right(), tick.pixel + 4, "end", inks_.text, tick.label);
        }
        for (const PlacedTick& tick : layout_.across) {
            text += line_between(tick.pixel, frame.y, tick.pixel, frame.bottom(), inks_.grid);
            text += line_between(tick.pixel, frame.bottom(), tick.pixel, frame.bottom() + tick_length, inks_.quiet);
            text +=
                text_at(tick.place.x + 0.5f * tick.place.width, frame.bottom() + 17, "middle", inks_.text, tick.label);
        }
        return text;
    }

    std::string border() const {
        const Box& frame = layout_.frame;
        return fmt::format(
            "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" stroke=\"{}\"/>\n",
            frame.x, frame.y, frame.width, frame.height, inks_.quiet);
    }

    /// What is cut off at the frame, by an element of its own: it needs no name, which would have to be unique in a
    /// page. Quiet curves lie behind the others.
    std::string in_frame() const {
        constexpr float over = 2;  // half a line or dot at the border
        const Box& frame = layout_.frame;
        std::string text = fmt::format(
            "<svg x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" "
            "viewBox=\"{0:.1f} {1:.1f} {2:.1f} {3:.1f}\" overflow=\"hidden\">\n",
            frame.x - over, frame.y - over, frame.width + 2 * over, frame.height + 2 * over);
        for (const Band& band : plot_.bands) text += area(band);
        text += moments();
        for (const bool in_front : {false, true}) {
            for (const std::size_t number : drawing_order(plot_)) {
                const Curve& curve = plot_.curves[number];
                if ((curve.colour != Curve::quiet) == in_front) text += path(curve);
            }
        }
        return text + "</svg>\n";
    }

    std::string area(const Band& band) const {
        const std::vector<Strip> all = strips(band, layout_.axes);
        std::string points;
        for (const Strip& strip : all) points += fmt::format("{:.2f},{:.2f} ", strip.x, strip.top);
        for (auto strip = all.rbegin(); strip != all.rend(); ++strip)
            points += fmt::format("{:.2f},{:.2f} ", strip->x, strip->bottom);
        return fmt::format("<polygon {} points=\"{}\"><title>{}</title></polygon>\n", area_of(band), points,
                           escaped(band.name));
    }

    std::string moments() const {
        std::string text;
        const Box& frame = layout_.frame;
        for (const MomentLine& line : moments_)
            text += line_between(line.pixel, frame.y, line.pixel, frame.bottom(), inks_.quiet);
        for (const auto& [moment, pixel, label] : moments_) {
            if (label.empty()) continue;
            text += text_at(label.x + 3, label.bottom() - 2, "start", inks_.dim, moment->text,
                            fmt::format(" font-size=\"{}\"{}", small_height, halo()));
        }
        return text;
    }

    std::string path(const Curve& curve) const {
        constexpr float few = 40;
        const std::vector<Point> shown = decimated(curve.x, curve.y, layout_.axes);
        const float radius = curve.large ? 5.0f : 2.2f;
        const bool marks = curve.large || curve.has_marks(told_apart(shown, layout_.frame, layout_.frame.width / few));
        std::string points, dots;
        for (const Point& point : shown) {
            points += fmt::format("{:.2f},{:.2f} ", point.x, point.y);
            if (marks)
                dots += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.1f}\"/>", point.x, point.y, radius);
        }
        if (shown.empty()) return {};
        return fmt::format(
            "<g class=\"curve\" data-name=\"{}\" stroke=\"{}\" fill=\"{}\"><title>{}</title><polyline "
            "fill=\"none\"{} stroke-linejoin=\"round\" points=\"{}\"/>{}</g>\n",
            escaped(curve.name.substr(0, curve.name.find(' '))), ink_of(curve.colour), ink_of(curve.colour),
            escaped(curve.name), stroke_of(curve), points, dots);
    }

    const Plot& plot_;
    const Inks& inks_;
    float width_, height_;
    Layout layout_;
    std::vector<MomentLine> moments_;
};

/// Powers of ten as in the texts of a page.
Plot with_readable_powers(Plot plot) {
    for (Quantity* quantity : {&plot.x, &plot.y}) {
        if (quantity->numbers == Numbers::typed) quantity->numbers = Numbers::readable;
    }
    return plot;
}

}  // namespace

std::string svg(const Plot& plot) {
    const Inks inks = inks_on_white();
    const Drawing drawing(plot, inks, 720, 440, 18);
    return drawing.content() + drawing.title(" font-size=\"14\" font-weight=\"bold\"") + drawing.legend() +
           drawing.caption() + "</svg>\n";
}

std::string svg_element(const Plot& plot, const Inks& inks) {
    if (!has_values(plot)) return {};
    const Plot readable = with_readable_powers(plot);
    const Drawing drawing(readable, inks, 600, 400, 0);
    return drawing.content() + drawing.title("") + drawing.names() + "</svg>\n";
}

}  // namespace steplab::plot
