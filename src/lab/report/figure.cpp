#include "lab/report/figure.hpp"

#include "core/entry.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "io/child_program.hpp"
#include "io/temporary_folder.hpp"
#include "lab/report/curve_labels.hpp"
#include "lab/report/svg.hpp"
#include "lab/report/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace steplab {

namespace {

bool can_stand(double value, bool logarithmic) { return std::isfinite(value) && (!logarithmic || value > 0); }

std::string file_text(const std::string& name) {
    std::ostringstream text;
    text << std::ifstream(name).rdbuf();
    return text.str();
}

/// A figure as input of gnuplot.
class Drawing {
public:
    Drawing(const Figure& figure, std::size_t number) : figure_(figure), number_(number) {
        x_range_ = figure.x.range ? figure.x.range : range_of(figure.curves, true, figure.x.logarithmic);
        y_range_ = figure.y.range ? figure.y.range : range_of(figure.curves, false, figure.y.logarithmic);
        for (const bool coloured : {false, true}) {  // coloured curves are drawn last, in front
            for (const Curve& curve : figure.curves) {
                if (curve.colour.has_value() == coloured && has_points(curve)) curves_.push_back(&curve);
            }
        }
    }

    /// Gnuplot fails on a diagram without a point.
    bool drawable() const { return x_range_ && y_range_ && !curves_.empty(); }

    std::string commands(const std::string& file) const {
        std::string text = fmt::format("set output '{}'\n", file);
        for (std::size_t c = 0; c < curves_.size(); ++c) text += data_block(*curves_[c], c);
        text += fmt::format("set xlabel '{}'\n", figure_.x.label) + axis("x", figure_.x, *x_range_) +
                axis("y", figure_.y, *y_range_) + labels() + "plot ";
        for (std::size_t c = 0; c < curves_.size(); ++c) text += (c ? ", \\\n" : "") + curve_command(*curves_[c], c);
        return text + "\nset output\n";
    }

    std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const Curve* curve : curves_) names.push_back(curve->name);
        return names;
    }

private:
    bool shown(const std::pair<double, double>& point) const {
        return can_stand(point.first, figure_.x.logarithmic) && can_stand(point.second, figure_.y.logarithmic);
    }

    bool has_points(const Curve& curve) const {
        return std::any_of(curve.points.begin(), curve.points.end(), [&](const auto& point) { return shown(point); });
    }

    std::string data_block(const Curve& curve, std::size_t c) const {
        std::string text = fmt::format("$f{}c{} << END\n", number_, c);
        for (const auto& point : curve.points) {
            if (shown(point)) text += fmt::format("{:.6g} {:.6g}\n", point.first, point.second);
        }
        return text + "END\n";
    }

    std::string curve_command(const Curve& curve, std::size_t c) const {
        const int colour = curve.colour ? first_of_palette + *curve.colour : background_curve;
        const bool marks = curve.marks && curve.colour;
        return fmt::format("$f{}c{} using 1:2 with {} lc rgb '{}' lw {} dt {}{} notitle", number_, c,
                           marks ? "linespoints" : "lines", placeholder(colour), curve.colour ? "1.7" : "0.8",
                           curve.dashed ? 2 : 1, marks ? " pt 7 ps 0.4" : "");
    }

    static std::string axis(const char* name, const Axis& axis, std::pair<double, double> range) {
        std::string text = fmt::format("set {}range [{:.9g}:{:.9g}]\n", name, range.first, range.second);
        if (!axis.logarithmic) return text + fmt::format("unset logscale {0}\nset {0}tics auto\n", name);
        text += fmt::format("set logscale {0}\nset {0}tics (", name);
        const char* comma = "";
        for (const Tick& tick : decades(range, axis.quantity)) {
            text += fmt::format("{}'{}' {:.9g} {}", comma, tick.text, tick.value, tick.text.empty() ? 1 : 0);
            comma = ", ";
        }
        return text + ")\n";
    }

    std::string labels() const {
        // the label of the vertical axis, because gnuplot would place it by its own estimate of the width of numbers
        std::string text =
            fmt::format("unset label\nset label '{}' at screen {:.4f},{:.4f} center rotate by 90 tc rgb '{}'\n",
                        figure_.y.label, 14 / FigureArea::width,
                        1 - (FigureArea::top + FigureArea::bottom) / 2 / FigureArea::height, placeholder(ink));
        for (const CurveLabel& label : curve_labels(figure_, *x_range_, *y_range_)) {
            text += fmt::format("set label '{}' at screen {:.4f},{:.4f} left tc rgb '{}' front\n", label.text,
                                label.x / FigureArea::width, 1 - label.y / FigureArea::height,
                                placeholder(first_of_palette + label.colour));
        }
        return text;
    }

    const Figure& figure_;
    std::size_t number_;
    std::optional<std::pair<double, double>> x_range_, y_range_;
    std::vector<const Curve*> curves_;
};

std::string style() {
    std::string text = fmt::format(
        "set encoding utf8\nset terminal svg size {},{} dynamic noenhanced font 'sans-serif,12' name 'f'\n"
        "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n"
        "set bmargin at screen {:.5f}\n",
        FigureArea::width, FigureArea::height, FigureArea::left / FigureArea::width,
        FigureArea::right / FigureArea::width, 1 - FigureArea::top / FigureArea::height,
        1 - FigureArea::bottom / FigureArea::height);
    text += fmt::format("set border 3 lc rgb '{}'\nset tics nomirror out scale 0.5,0.3 textcolor rgb '{}'\n",
                        placeholder(quiet), placeholder(ink));
    return text +
           fmt::format("set grid lc rgb '{}' lt 1 lw 0.6\nset xlabel textcolor rgb '{}' offset 0,0.3\nunset key\n",
                       placeholder(grid), placeholder(ink));
}

/// Gnuplot's messages are not shown on the terminal: warnings are dropped, an error is quoted.
void run_gnuplot(const std::string& script) {
    ChildProgram gnuplot({"gnuplot", script});
    const ChildProgram::End end = gnuplot.end();
    if (end == ChildProgram::End::done) return;
    throw FileError(end == ChildProgram::End::missing
                        ? "cannot run gnuplot, which draws the diagrams: install the package gnuplot-nox"
                        : fmt::format("gnuplot, which draws the diagrams, failed: {}", gnuplot.messages()));
}

}  // namespace

std::optional<std::pair<double, double>> range_of(std::span<const Curve> curves, bool of_x, bool logarithmic) {
    double low = infinity, high = -infinity;
    for (const Curve& curve : curves) {
        for (const auto& [x, y] : curve.points) {
            const double value = of_x ? x : y;
            if (!can_stand(value, logarithmic)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (!(low <= high)) return std::nullopt;
    if (logarithmic) return std::pair(low / 1.5, high * 1.5);
    const double room = high > low ? 0 : std::max(1.0, std::abs(low));
    return std::pair(low - room, high + room);
}

std::vector<std::string> svg_figures(std::span<const Figure> figures) {
    const TemporaryFolder folder;
    const auto picture = [&](std::size_t i) { return folder.file(fmt::format("{}.svg", i)); };
    std::vector<Drawing> drawings;
    std::string script = style();
    for (std::size_t i = 0; i < figures.size(); ++i) {
        drawings.emplace_back(figures[i], i);
        if (drawings[i].drawable()) script += drawings[i].commands(picture(i));
    }
    std::ofstream(folder.file("figures.gp")) << script;
    run_gnuplot(folder.file("figures.gp"));
    std::vector<std::string> elements;
    for (std::size_t i = 0; i < figures.size(); ++i)
        elements.push_back(page_svg(file_text(picture(i)), drawings[i].names()));
    return elements;
}

}  // namespace steplab
