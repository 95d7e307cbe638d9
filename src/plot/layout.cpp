#include "plot/layout.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::plot {
namespace {

// Lengths in units of the layout.
constexpr float usual_left = 52;
constexpr float right = 16;
constexpr float above = 34;     // the title
constexpr float below = 42;     // labels and the name of the axis
constexpr float label_gap = 7;  // between a label and the frame
constexpr float edge = 4;       // between a label and the edge of the plot
constexpr float between = 8;    // between neighbouring labels

/// Measures and places labels.
class Labels {
public:
    Labels(const Lettering& lettering, const Box& box) : lettering_(lettering), box_(box) {}

    float px(float units) const { return lettering_.unit * units; }
    float width(const std::string& text) const { return lettering_.width(text); }
    float height() const { return lettering_.height; }

    /// Left of the frame, centred at the height of its grid line.
    PlacedTick left_of(const Box& frame, const Axis& up, const Tick& tick) const {
        const float y = std::round(up.pixel(tick.value));
        const float wide = width(tick.label);
        return {y, tick.label, {frame.x - px(label_gap) - wide, y - 0.5f * height(), wide, height()}};
    }
    /// Below the frame, centred at its grid line, or beside that where the plot ends.
    PlacedTick below(const Box& frame, const Axis& across, const Tick& tick) const {
        const float x = std::round(across.pixel(tick.value));
        const float wide = width(tick.label);
        const float last = box_.right() - px(edge) - wide;
        const float from = std::max(std::min(x - 0.5f * wide, last), box_.x + px(edge));
        return {x, tick.label, {from, frame.bottom() + px(label_gap - 3), wide, height()}};
    }
    bool apart(const Box& a, const Box& b) const {
        const float gap = px(between);
        return a.right() + gap <= b.x || b.right() + gap <= a.x || a.bottom() <= b.y || b.bottom() <= a.y;
    }
    bool inside(const Box& label) const {
        return label.x >= box_.x && label.right() <= box_.right() && label.y >= box_.y &&
               label.bottom() <= box_.bottom();
    }

private:
    const Lettering& lettering_;
    Box box_;
};

bool all_apart(const std::vector<PlacedTick>& ticks, const Labels& labels) {
    for (std::size_t i = 1; i < ticks.size(); ++i) {
        if (!labels.apart(ticks[i - 1].place, ticks[i].place)) return false;
    }
    return true;
}

/// Leaves out the labels without room, which not even the fewest ticks have.
void drop_labels(std::vector<PlacedTick>& ticks, const Labels& labels) {
    const Box* last = nullptr;
    for (PlacedTick& tick : ticks) {
        if (labels.inside(tick.place) && (!last || labels.apart(*last, tick.place))) {
            last = &tick.place;
        } else {
            tick.label.clear();
        }
    }
}

/// As many as have room. One number alone would not say how long the axis is: then more, of which drop_labels() leaves
/// those that have room.
std::vector<PlacedTick> ticks_across(const Labels& labels, const Layout& layout) {
    const auto placed = [&](int most) {
        std::vector<PlacedTick> all;
        for (const Tick& tick : ticks(layout.axes.across, most))
            all.push_back(labels.below(layout.frame, layout.axes.across, tick));
        return all;
    };
    const int usual = std::max(2, static_cast<int>(layout.frame.width / labels.px(80)));
    int most = usual;
    std::vector<PlacedTick> best = placed(most);
    while (most > 1 && !all_apart(best, labels)) best = placed(--most);
    for (int more = most + 1; best.size() < 2 && more <= usual + 4; ++more) best = placed(more);
    return best;
}

}  // namespace

Layout layout_of(const Plot& plot, const Box& box, const Lettering& lettering) {
    const Labels labels(lettering, box);
    const auto px = [&](float units) { return labels.px(units); };
    Layout layout;
    Box& frame = layout.frame;
    frame.y = std::round(box.y + px(above));
    frame.height = std::max(1.0f, std::round(box.height - px(above) - px(below)));
    const int intervals = std::max(2, static_cast<int>(std::lround(frame.height / px(32))));
    const std::vector<Tick> ticks_up = ticks(axes(plot, frame, intervals).up, intervals);
    float widest = 0;
    for (const Tick& tick : ticks_up) widest = std::max(widest, labels.width(tick.label));
    const float left = std::min(std::max(px(usual_left), widest + px(label_gap + edge)), 0.5f * box.width);
    frame.x = std::round(box.x + left);
    frame.width = std::max(1.0f, std::round(box.width - left - px(right)));
    layout.axes = axes(plot, frame, intervals);
    for (const Tick& tick : ticks_up) layout.up.push_back(labels.left_of(frame, layout.axes.up, tick));
    drop_labels(layout.up, labels);
    layout.across = ticks_across(labels, layout);
    drop_labels(layout.across, labels);
    return layout;
}

}  // namespace steplab::plot
