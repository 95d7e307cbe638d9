#include "plot/moment_labels.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::plot {
namespace {

// Lengths in units of the layout.
constexpr float from_line = 3;     // between a line and its label, and behind that
constexpr float between_rows = 2;  // between rows, and below the lowest

/// Gives labels their places, one after the other.
class Rows {
public:
    Rows(const Box& frame, const Lettering& lettering)
        : frame_(frame), lettering_(lettering), height_(lettering.height + between_rows * lettering.unit) {
        constexpr float part = 0.25f;  // of the frame, at most: the rest is for the curves
        count_ = std::clamp(static_cast<int>(part * frame.height / height_), 1, 3);
    }

    /// Empty if there is no room.
    Box take(float pixel, const std::string& text) {
        const float gap = from_line * lettering_.unit, width = lettering_.width(text) + 2 * gap;
        const float left = pixel + width <= frame_.right() ? pixel : pixel - width;
        if (left < frame_.x) return {};
        for (int row = 0; row < count_; ++row) {
            const Box place{left, frame_.bottom() - static_cast<float>(row + 1) * height_, width, lettering_.height};
            if (std::any_of(taken_.begin(), taken_.end(), [&](const Box& other) { return place.meets(other); }))
                continue;
            taken_.push_back(place);
            return place;
        }
        return {};
    }

private:
    Box frame_;
    const Lettering& lettering_;
    float height_;
    int count_;
    std::vector<Box> taken_;
};

}  // namespace

std::vector<MomentLine> moment_lines(const Plot& plot, const Layout& layout, const Lettering& lettering) {
    std::vector<MomentLine> lines;
    for (const Moment& moment : plot.moments) {
        const float pixel = std::round(layout.axes.across.pixel(moment.x));
        if (pixel >= layout.frame.x && pixel <= layout.frame.right()) lines.push_back({&moment, pixel, {}});
    }
    Rows rows(layout.frame, lettering);
    for (auto line = lines.rbegin(); line != lines.rend(); ++line)
        line->label = rows.take(line->pixel, line->moment->text);
    return lines;
}

float height_of_labels(std::span<const MomentLine> lines, const Box& frame) {
    float height = 0;
    for (const MomentLine& line : lines) {
        if (!line.label.empty()) height = std::max(height, frame.bottom() - line.label.y);
    }
    return height;
}

std::vector<const Moment*> moments_at(const Plot& plot, const Axes& axes, float pointer, float reach) {
    std::vector<const Moment*> moments;
    for (const Moment& moment : plot.moments) {
        if (std::abs(axes.across.pixel(moment.x) - pointer) <= reach) moments.push_back(&moment);
    }
    return moments;
}

}  // namespace steplab::plot
