#include "plot/curve_names.hpp"

#include <algorithm>
#include <array>

namespace steplab::plot {
namespace {

bool within(const Box& box, const Box& frame) {
    return box.x >= frame.x && box.right() <= frame.right() && box.y >= frame.y && box.bottom() <= frame.bottom();
}

std::vector<Point> points_in_frame(const Curve& curve, const Layout& layout) {
    std::vector<Point> points = decimated(curve.x, curve.y, layout.axes);
    const Box& frame = layout.frame;
    std::erase_if(
        points, [&](Point p) { return p.x < frame.x || p.x > frame.right() || p.y < frame.y || p.y > frame.bottom(); });
    return points;
}

/// Finds places, one name after the other.
class Places {
public:
    Places(const Plot& plot, const Layout& layout, const Lettering& lettering)
        : layout_(layout), lettering_(lettering) {
        for (const Curve& curve : plot.curves)
            points_.push_back(curve.colour == Curve::quiet ? std::vector<Point>() : points_in_frame(curve, layout));
    }

    const std::vector<Point>& points(std::size_t curve) const { return points_[curve]; }

    /// Names at the end of a curve are preferred.
    Box take(std::size_t curve, const std::string& name) {
        Box best;
        double least = 1e9, from_end = 0;
        const std::vector<Point>& points = points_[curve];
        for (auto point = points.rbegin(); point != points.rend(); ++point, from_end += 0.2) {
            for (const Box& box : next_to(*point, name)) {
                const double sum = cost(box) + from_end;
                if (sum >= least) continue;
                best = box;
                least = sum;
            }
        }
        taken_.push_back(best);
        return best;
    }

private:
    /// Right, left, above and below.
    std::array<Box, 6> next_to(Point p, const std::string& name) const {
        const float width = lettering_.width(name) + 4 * lettering_.unit, height = lettering_.height + 1;
        const float gap = 6 * lettering_.unit;
        const auto box = [&](float left, float middle) { return Box{left, middle - height / 2, width, height}; };
        const float aside = 0.8f * height, over = 1.1f * height;
        return {box(p.x + gap, p.y),         box(p.x - gap - width, p.y),      box(p.x + gap, p.y - aside),
                box(p.x + gap, p.y + aside), box(p.x - width / 2, p.y - over), box(p.x - width / 2, p.y + over)};
    }

    double cost(const Box& box) const {
        double sum = within(box, layout_.frame) ? 0 : 1000;
        for (const Box& other : taken_) sum += box.meets(other) ? 200 : 0;
        for (const auto& curve : points_)
            sum += static_cast<double>(
                std::count_if(curve.begin(), curve.end(), [&](Point p) { return box.contains(p.x, p.y); }));
        return sum;
    }

    const Layout& layout_;
    const Lettering& lettering_;
    std::vector<std::vector<Point>> points_;
    std::vector<Box> taken_;
};

}  // namespace

std::vector<CurveName> curve_names(const Plot& plot, const Layout& layout, const Lettering& lettering) {
    Places places(plot, layout, lettering);
    std::vector<CurveName> names;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        if (places.points(i).empty()) continue;
        const Curve& curve = plot.curves[i];
        names.push_back({curve.name, curve.colour, places.take(i, curve.name)});
    }
    return names;
}

}  // namespace steplab::plot
