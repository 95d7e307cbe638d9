#include "plot/free_corner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace steplab::plot {
namespace {

/// The part of a stretch from `start` by `way` that lies between two bounds, cut out of what is given [0 ... 1].
void cut(float start, float way, float low, float high, float& from, float& to) {
    if (way == 0) {
        if (start < low || start > high) to = from;
        return;
    }
    const float a = (low - start) / way, b = (high - start) / way;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
}

/// The highest point that is higher than its neighbours, or its one neighbour: what a plot is looked at for.
std::optional<Point> highest_peak(std::span<const std::vector<Point>> lines, const Box& frame) {
    std::optional<Point> best;
    for (const std::vector<Point>& line : lines) {
        for (std::size_t i = 0; line.size() > 1 && i < line.size(); ++i) {
            const bool peak =
                (i == 0 || line[i].y < line[i - 1].y) && (i + 1 == line.size() || line[i].y < line[i + 1].y);
            const bool seen = line[i].x >= frame.x && line[i].x <= frame.right() && line[i].y >= frame.y;
            if (peak && seen && (!best || line[i].y < best->y)) best = line[i];
        }
    }
    return best;
}

}  // namespace

Box card_in(const Box& frame, Corner corner, float width, float height, float above) {
    const bool left = corner == Corner::top_left || corner == Corner::bottom_left;
    const bool top = corner == Corner::top_left || corner == Corner::top_right;
    const float lowest = std::max(frame.y, frame.bottom() - above - height);
    return {left ? frame.x + 1 : frame.right() - 1 - width, top ? frame.y : lowest, width, height};
}

// After Liang and Barsky, ACM Transactions on Graphics 3 (1984) 1.
float length_within(std::span<const Point> line, const Box& box) {
    float sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point &a = line[i - 1], &b = line[i];
        float from = 0, to = 1;
        cut(a.x, b.x - a.x, box.x, box.right(), from, to);
        cut(a.y, b.y - a.y, box.y, box.bottom(), from, to);
        if (to > from) sum += (to - from) * std::hypot(b.x - a.x, b.y - a.y);
    }
    return sum;
}

Corner free_corner(std::span<const std::vector<Point>> lines, const Box& frame, const Box& card, float above,
                   Corner present, float worth) {
    const std::optional<Point> peak = highest_peak(lines, frame);
    const auto covered = [&](Corner corner) {
        const Box box = card_in(frame, corner, card.width, card.height, above);
        float sum = peak && box.contains(peak->x, peak->y) ? 2 * (card.width + card.height) : 0;
        for (const std::vector<Point>& line : lines) sum += length_within(line, box);
        return sum;
    };
    constexpr std::array corners{Corner::top_right, Corner::top_left, Corner::bottom_right, Corner::bottom_left};
    const float now = covered(present);
    Corner best = present;
    float least = now;
    for (const Corner corner : corners) {
        const float sum = covered(corner);
        if (sum < least) {
            best = corner;
            least = sum;
        }
    }
    return now > 2 * least + worth ? best : present;
}

}  // namespace steplab::plot
