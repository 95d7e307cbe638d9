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

/// True if a line is higher there than at its neighbours, or its one neighbour.
bool is_peak(std::span<const Point> line, std::size_t i) {
    return (i == 0 || line[i].y < line[i - 1].y) && (i + 1 == line.size() || line[i].y < line[i + 1].y);
}

/// The highest peak that the frame shows: what a plot is looked at for. None of an oscillation, whose peaks are equally
/// high: now one of them, now another would be the highest by rounding.
std::optional<Point> highest_peak(std::span<const std::vector<Point>> lines, const Box& frame) {
    constexpr float equal = 3;  // pixels: where samples fall on a crest differs by one or two
    std::optional<Point> best;
    float next = frame.bottom();  // height of the second
    for (const std::vector<Point>& line : lines) {
        for (std::size_t i = 0; line.size() > 1 && i < line.size(); ++i) {
            const Point point = line[i];
            const bool seen = point.x >= frame.x && point.x <= frame.right() && point.y >= frame.y;
            if (!seen || !is_peak(line, i)) continue;
            const bool higher = !best || point.y < best->y;
            if (best) next = std::min(next, std::max(point.y, best->y));
            if (higher) best = point;
        }
    }
    return best && next > best->y + equal ? best : std::nullopt;
}

/// What a card in a corner covers.
class Covered {
public:
    Covered(std::span<const std::vector<Point>> lines, const Box& frame, const Box& card, float above)
        : lines_(lines), frame_(frame), card_(card), above_(above), peak_(highest_peak(lines, frame)) {}

    float all(Corner corner) const {
        const Box box = box_in(corner);
        float sum = peak_ && box.contains(peak_->x, peak_->y) ? 2 * (card_.width + card_.height) : 0;
        for (const std::vector<Point>& line : lines_) sum += length_within(line, box);
        return sum;
    }
    /// Of the last tenth of each line: where a run is now.
    float newest(Corner corner) const {
        float sum = 0;
        for (const std::vector<Point>& line : lines_)
            sum += length_within(std::span(line).last((line.size() + 9) / 10), box_in(corner));
        return sum;
    }

private:
    Box box_in(Corner corner) const { return card_in(frame_, corner, card_.width, card_.height, above_); }

    std::span<const std::vector<Point>> lines_;
    Box frame_, card_;
    float above_;
    std::optional<Point> peak_;
};

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
    const Covered covered(lines, frame, card, above);
    constexpr std::array corners{Corner::top_right, Corner::top_left, Corner::bottom_right, Corner::bottom_left};
    const float now = covered.all(present);
    Corner best = present;
    float least = now;
    for (const Corner corner : corners) {
        const float sum = covered.all(corner);
        if (sum < least) {
            best = corner;
            least = sum;
        }
    }
    const bool hides_the_newest = least == 0 && covered.newest(present) > 0;
    return hides_the_newest || now > 2 * least + worth ? best : present;
}

}  // namespace steplab::plot
