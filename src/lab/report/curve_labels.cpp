#include "lab/report/curve_labels.hpp"

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

struct Pixel {
    double x, y;
};

struct Box {
    double left, top, right, bottom;

    bool holds(Pixel p) const { return p.x > left && p.x < right && p.y > top && p.y < bottom; }
    bool meets(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
    bool within_frame() const {
        return left >= FigureArea::left && right <= FigureArea::right && top >= FigureArea::top &&
               bottom <= FigureArea::bottom;
    }
};

/// Where a value lies between the ends of an axis, 0 .. 1.
double part(double value, std::pair<double, double> range, bool logarithmic) {
    const auto on = [&](double v) { return logarithmic ? std::log(v) : v; };
    return (on(value) - on(range.first)) / (on(range.second) - on(range.first));
}

std::vector<Pixel> pixels(const Curve& curve, const Figure& figure, std::pair<double, double> x_range,
                          std::pair<double, double> y_range) {
    std::vector<Pixel> found;
    for (const auto& [x, y] : curve.points) {
        const double across = part(x, x_range, figure.x.logarithmic), up = part(y, y_range, figure.y.logarithmic);
        if (!(across >= 0 && across <= 1 && up >= 0 && up <= 1)) continue;
        found.push_back({FigureArea::left + across * (FigureArea::right - FigureArea::left),
                         FigureArea::bottom - up * (FigureArea::bottom - FigureArea::top)});
    }
    return found;
}

/// Possible positions of a text next to a point: right, left, above and below.
std::vector<Box> places_next_to(Pixel p, const std::string& text) {
    const double width = 6.4 * static_cast<double>(text.size()) + 4;
    constexpr double height = 13, gap = 6;
    const auto box = [&](double left, double middle) {
        return Box{left, middle - height / 2, left + width, middle + height / 2};
    };
    return {box(p.x + gap, p.y),      box(p.x - gap - width, p.y),    box(p.x + gap, p.y - 10),
            box(p.x + gap, p.y + 10), box(p.x - width / 2, p.y - 14), box(p.x - width / 2, p.y + 14)};
}

}  // namespace

std::vector<CurveLabel> curve_labels(const Figure& figure, std::pair<double, double> x_range,
                                     std::pair<double, double> y_range) {
    std::vector<std::vector<Pixel>> marks;
    for (const Curve& curve : figure.curves) {
        marks.push_back(curve.colour ? pixels(curve, figure, x_range, y_range) : std::vector<Pixel>());
    }
    std::vector<Box> taken;
    const auto cost = [&](const Box& box) {
        double sum = box.within_frame() ? 0 : 1000;
        for (const Box& other : taken) sum += box.meets(other) ? 200 : 0;
        for (const auto& curve : marks)
            sum +=
                static_cast<double>(std::count_if(curve.begin(), curve.end(), [&](Pixel p) { return box.holds(p); }));
        return sum;
    };
    std::vector<CurveLabel> labels;
    for (std::size_t c = 0; c < figure.curves.size(); ++c) {
        if (marks[c].empty()) continue;
        const Curve& curve = figure.curves[c];
        Box best{};
        double least = 1e9;
        double from_end = 0;  // names at the end of a line are preferred
        for (auto point = marks[c].rbegin(); point != marks[c].rend(); ++point, from_end += 0.2) {
            for (const Box& box : places_next_to(*point, curve.name)) {
                const double sum = cost(box) + from_end;
                if (sum < least) {
                    best = box;
                    least = sum;
                }
            }
        }
        taken.push_back(best);
        labels.push_back({curve.name, *curve.colour, best.left + 2, (best.top + best.bottom) / 2});
    }
    return labels;
}

}  // namespace steplab
