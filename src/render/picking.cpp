#include "render/picking.hpp"

#include "render/bounds.hpp"

#include <cmath>
#include <limits>

namespace steplab::render {
namespace {

/// A particle as a disc in the picture.
struct Disc {
    PixelPoint centre;
    double radius;
    double depth;
};

/// None for particles behind the camera or at no place that can be drawn.
std::optional<Disc> disc_of(const Frame& frame, std::size_t i, const DrawnSizes& sizes, const Projection& projection) {
    const Vec3 position = frame.seen(i);
    if (!drawable(position)) return std::nullopt;
    const auto centre = projection.pixel(position);
    if (!centre) return std::nullopt;
    const double depth = projection.depth(position);
    return Disc{*centre, sizes.radius(frame.shape->roles[i]) * projection.pixels_per_unit(depth), depth};
}

}  // namespace

std::optional<std::size_t> particle_at(const Frame& frame, const DrawnSizes& sizes, const Projection& projection,
                                       PixelPoint pixel, double tolerance) {
    std::optional<std::size_t> under, beside;
    double least_depth = std::numeric_limits<double>::infinity();
    double least_beyond = tolerance;
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        const auto disc = disc_of(frame, i, sizes, projection);
        if (!disc) continue;
        const double dx = disc->centre.x - pixel.x, dy = disc->centre.y - pixel.y;
        const double reach = disc->radius + tolerance;
        if (!(dx * dx + dy * dy <= reach * reach)) continue;
        const double beyond = std::sqrt(dx * dx + dy * dy) - disc->radius;
        if (beyond <= 0 && disc->depth < least_depth) {
            under = i;
            least_depth = disc->depth;
        } else if (beyond > 0 && beyond <= least_beyond) {
            beside = i;
            least_beyond = beyond;
        }
    }
    return under ? under : beside;
}

bool any_in_view(const Frame& frame, const DrawnSizes& sizes, const Projection& projection) {
    const auto [width, height] = projection.size();
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        const auto disc = disc_of(frame, i, sizes, projection);
        if (!disc) continue;
        const auto [x, y] = disc->centre;
        const double r = disc->radius;
        if (x + r > 0 && y + r > 0 && x - r < width && y - r < height) return true;
    }
    return false;
}

}  // namespace steplab::render
