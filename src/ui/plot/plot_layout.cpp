#include "ui/plot/plot_layout.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

// Lengths in units of the layout.
constexpr float usual_left = 52;
constexpr float right = 16;
constexpr float above = 34;     // the title
constexpr float below = 42;     // labels and the name of the axis
constexpr float label_gap = 7;  // between a label and the frame
constexpr float edge = 4;       // between a label and the edge of the plot
constexpr float between = 8;    // between neighbouring labels

/// Measures and places labels in the small font.
class Labels {
public:
    Labels(const Theme& theme, const Area& area) : theme_(theme), font_(*theme.fonts().small), area_(area) {}

    float width(const std::string& text) const { return font_.CalcTextSizeA(font_.FontSize, 1e9f, 0, text.c_str()).x; }
    float height() const { return font_.FontSize; }

    /// Left of the frame, centred at the height of its grid line.
    PlacedTick left_of(const Area& frame, const Axis& up, const Tick& tick) const {
        const float y = std::round(up.pixel(tick.value));
        const float wide = width(tick.label);
        return {y, tick.label, {frame.x - theme_.px(label_gap) - wide, y - 0.5f * height(), wide, height()}};
    }
    /// Below the frame, centred at its grid line, or beside that where the plot ends.
    PlacedTick below(const Area& frame, const Axis& across, const Tick& tick) const {
        const float x = std::round(across.pixel(tick.value));
        const float wide = width(tick.label);
        const float last = area_.right() - theme_.px(edge) - wide;
        const float from = std::max(std::min(x - 0.5f * wide, last), area_.x + theme_.px(edge));
        return {x, tick.label, {from, frame.bottom() + theme_.px(label_gap - 3), wide, height()}};
    }
    bool apart(const Area& a, const Area& b) const {
        const float gap = theme_.px(between);
        return a.right() + gap <= b.x || b.right() + gap <= a.x || a.bottom() <= b.y || b.bottom() <= a.y;
    }
    bool inside(const Area& label) const {
        return label.x >= area_.x && label.right() <= area_.right() && label.y >= area_.y &&
               label.bottom() <= area_.bottom();
    }

private:
    const Theme& theme_;
    const ImFont& font_;
    Area area_;
};

bool all_apart(const std::vector<PlacedTick>& ticks, const Labels& labels) {
    for (std::size_t i = 1; i < ticks.size(); ++i) {
        if (!labels.apart(ticks[i - 1].place, ticks[i].place)) return false;
    }
    return true;
}

/// Leaves out the labels without room, which not even the fewest ticks have.
void drop_labels(std::vector<PlacedTick>& ticks, const Labels& labels) {
    const Area* last = nullptr;
    for (PlacedTick& tick : ticks) {
        if (labels.inside(tick.place) && (!last || labels.apart(*last, tick.place))) {
            last = &tick.place;
        } else {
            tick.label.clear();
        }
    }
}

std::vector<PlacedTick> ticks_across(const Theme& theme, const Labels& labels, const PlotLayout& layout) {
    std::vector<PlacedTick> placed;
    for (int most = std::max(2, static_cast<int>(layout.frame.width / theme.px(80))); most >= 1; --most) {
        placed.clear();
        for (const Tick& tick : ticks(layout.axes.across, most)) {
            placed.push_back(labels.below(layout.frame, layout.axes.across, tick));
        }
        if (all_apart(placed, labels)) break;
    }
    return placed;
}

}  // namespace

PlotLayout plot_layout(const Theme& theme, const Plot& plot, const Area& area) {
    const Labels labels(theme, area);
    PlotLayout layout;
    layout.frame.y = std::round(area.y + theme.px(above));
    layout.frame.height = std::max(1.0f, std::round(area.height - theme.px(above) - theme.px(below)));
    const int intervals = std::max(2, static_cast<int>(std::lround(layout.frame.height / theme.px(32))));
    const Axis up = plot_axes(plot, layout.frame, intervals).up;
    const std::vector<Tick> ticks_up = ticks(up, intervals);
    float widest = 0;
    for (const Tick& tick : ticks_up) widest = std::max(widest, labels.width(tick.label));
    const float left = std::min(std::max(theme.px(usual_left), widest + theme.px(label_gap + edge)), 0.5f * area.width);
    layout.frame.x = std::round(area.x + left);
    layout.frame.width = std::max(1.0f, std::round(area.width - left - theme.px(right)));
    layout.axes = plot_axes(plot, layout.frame, intervals);
    for (const Tick& tick : ticks_up) layout.up.push_back(labels.left_of(layout.frame, layout.axes.up, tick));
    drop_labels(layout.up, labels);
    layout.across = ticks_across(theme, labels, layout);
    drop_labels(layout.across, labels);
    return layout;
}

}  // namespace steplab::ui
