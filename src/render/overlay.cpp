#include "render/overlay.hpp"

#include "core/number_text.hpp"
#include "core/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace steplab::render {
namespace {

struct Arm {
    Vec3 direction;
    const char* name;
    Rgb colour;
};

constexpr double cross_reach = 30;  // pixels at scale 1

PixelPoint cross_centre(PictureSize size, double pixel_scale) {
    return {56 * pixel_scale, size.height - 52 * pixel_scale};
}

/// Its ends, centre and, for strain, the quarters.
std::vector<LegendMark> marks_of_quantity(const ColourScale& scale) {
    std::vector<LegendMark> marks;
    for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const bool quarter = part == 0.25 || part == 0.75;
        if (quarter && !(scale.minimum < 0)) continue;
        marks.push_back({part, typed(std::lerp(scale.minimum, scale.maximum, part), 3)});
    }
    return marks;
}

/// Ticks as of axes; the ends of a range that is too small for some.
std::vector<LegendMark> marks_of_column(const ColourScale& scale) {
    const double step = nice_step(scale.minimum, scale.maximum, 4);
    const double largest = std::max(std::abs(scale.minimum), std::abs(scale.maximum));
    std::vector<LegendMark> marks;
    for (const double tick : linear_ticks(scale.minimum, scale.maximum, step)) {
        const double part = std::clamp(part_between(scale.minimum, scale.maximum, tick), 0.0, 1.0);
        marks.push_back({part, tick_text(tick, step, largest)});
    }
    if (marks.empty()) return {{0, typed(scale.minimum, 17)}, {1, typed(scale.maximum, 17)}};
    return marks;
}

/// Whether the area has a part of a box of this size.
bool touches(const PictureArea& area, PixelPoint low, PixelPoint size) {
    return low.x < area.left + area.size.width && low.x + size.x > area.left && low.y < area.top + area.size.height &&
           low.y + size.y > area.top;
}

}  // namespace

PixelPoint place_of(const AxisLabel& label, PixelPoint text, PictureSize picture) {
    constexpr double margin = 2;
    const PixelPoint most{picture.width - text.x - margin, picture.height - text.y - margin};
    const auto low = [&](PixelPoint centre) { return PixelPoint{centre.x - text.x / 2, centre.y - text.y / 2}; };
    const auto fits = [&](PixelPoint p) { return p.x >= margin && p.y >= margin && p.x <= most.x && p.y <= most.y; };
    const PixelPoint centre = fits(low(label.centre)) ? label.centre : label.nearer.value_or(label.centre);
    const bool is_seen = centre.x >= 0 && centre.y >= 0 && centre.x <= picture.width && centre.y <= picture.height;
    const PixelPoint place = low(centre);
    if (!is_seen && !label.nearer) return place;
    return {std::clamp(place.x, margin, std::max(margin, most.x)),
            std::clamp(place.y, margin, std::max(margin, most.y))};
}

void sketch_labels(Sketch& sketch, const Axes& axes, const Occupancy& taken, const PictureArea& texts,
                   PictureSize picture, const Palette& palette) {
    constexpr double legible = 0.5;  // a fainter text is not drawn: no text is half there
    for (const AxisLabel& label : axes.labels) {
        const PixelPoint size = sketch.text_size(label.text);
        const PixelPoint low = place_of(label, size, picture);
        if (touches(texts, low, size)) continue;
        const double in_the_way = taken.taken(low, {low.x + size.x, low.y + size.y});
        if (label.strength * (1 - in_the_way) < legible) continue;
        sketch.text_over(low, label.text, palette.text, backdrop_at(palette, 1 - label.centre.y / picture.height));
    }
}

void mark_cross(Occupancy& taken, PictureSize size, double pixel_scale) {
    taken.mark(cross_centre(size, pixel_scale), (cross_reach + 14) * pixel_scale);
}

PictureArea cross_area(PictureSize size, double pixel_scale) {
    const PixelPoint centre = cross_centre(size, pixel_scale);
    const auto reach = static_cast<int>((cross_reach + 16) * pixel_scale);
    return {static_cast<int>(centre.x) - reach, static_cast<int>(centre.y) - reach, {2 * reach, 2 * reach}};
}

void sketch_cross(Sketch& sketch, const Projection& projection, const Palette& palette, double pixel_scale) {
    const double reach = cross_reach * pixel_scale;
    const PixelPoint centre = cross_centre(projection.size(), pixel_scale);
    std::array<Arm, 3> arms{
        {{{1, 0, 0}, "x", palette.axes[0]}, {{0, 1, 0}, "y", palette.axes[1]}, {{0, 0, 1}, "z", palette.axes[2]}}};
    // Arms are drawn from the farthest to the nearest.
    std::sort(arms.begin(), arms.end(), [&](const Arm& a, const Arm& b) {
        return dot(a.direction, projection.forward()) > dot(b.direction, projection.forward());
    });
    for (const Arm& arm : arms) {
        const double x = dot(arm.direction, projection.right());
        const double y = -dot(arm.direction, projection.up());
        const double letter = reach + 11 * pixel_scale;
        sketch.line(centre, {centre.x + reach * x, centre.y + reach * y}, arm.colour, 1.8 * pixel_scale);
        // The letter of an arm that points at the camera is placed beside it.
        const double near_eye = 1 - std::min(std::hypot(x, y) / 0.4, 1.0);
        const PixelPoint size = sketch.text_size(arm.name);
        sketch.text_over({centre.x + letter * x + 10 * pixel_scale * near_eye - size.x / 2,
                          centre.y + letter * y + 8 * pixel_scale * near_eye - size.y / 2},
                         arm.name, arm.colour, palette.bottom);
    }
}

void sketch_share(Sketch& sketch, std::size_t one_of, PictureSize size, const Palette& palette, double pixel_scale) {
    const std::string text = fmt::format("1 of {} distant particles drawn", one_of);
    const PixelPoint extent = sketch.text_size(text);
    const PixelPoint place{size.width - 28 * pixel_scale - extent.x, size.height - 24 * pixel_scale - extent.y};
    sketch.text_over(place, text, palette.text, backdrop_at(palette, 1 - place.y / size.height));
}

std::vector<LegendMark> legend_marks(const ColourScale& scale) {
    return scale.column ? marks_of_column(scale) : marks_of_quantity(scale);
}

void sketch_legend(Sketch& sketch, const ColourScale& scale, PictureSize size, const Palette& palette,
                   double pixel_scale, double lower) {
    const double width = 11 * pixel_scale;
    const double height = std::min(160 * pixel_scale, 0.4 * size.height);
    const double right = size.width - 28 * pixel_scale;
    const double top = 58 * pixel_scale + lower;
    const std::string heading = title(scale);
    const auto write = [&](PixelPoint place, const std::string& text) {
        sketch.text_over(place, text, palette.text, backdrop_at(palette, 1 - place.y / size.height));
    };
    write({right - sketch.text_size(heading).x, top - 28 * pixel_scale}, heading);
    constexpr int bands = 32;
    const auto value = [&](double part) { return std::lerp(scale.maximum, scale.minimum, part); };
    for (int band = 0; band < bands; ++band) {
        const double from = static_cast<double>(band) / bands;
        const double to = static_cast<double>(band + 1) / bands;
        sketch.shaded_box({right - width, top + height * from}, {right, top + height * to},
                          scale.colour(value(from), palette), scale.colour(value(to), palette));
    }
    for (const LegendMark& mark : legend_marks(scale)) {
        const double y = top + height * (1 - mark.part);
        const PixelPoint extent = sketch.text_size(mark.text);
        write({right - width - 8 * pixel_scale - extent.x, y - extent.y / 2}, mark.text);
    }
}

}  // namespace steplab::render
