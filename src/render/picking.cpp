#include "render/picking.hpp"

#include "render/bounds.hpp"

#include <algorithm>
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

/// Rules out most particles by some products each: the pointer rests over scenes of a million.
class NearPointer {
public:
    NearPointer(const DrawnSizes& sizes, const Projection& p, PixelPoint pixel, double tolerance)
        : eye_(p.eye()),
          forward_(p.forward()),
          right_(p.right()),
          up_(p.up()),
          pixels_(p.pixels_per_unit(1)),
          x_(pixel.x - 0.5 * p.size().width),
          y_(0.5 * p.size().height - pixel.y),
          tolerance_(tolerance) {
        for (const Role role : {Role::moving, Role::fixed, Role::kicked, Role::bullet})
            radius_ = std::max(radius_, sizes.radius(role));
    }

    /// False only where the disc of a particle there does not come as near to the pixel as the tolerance.
    bool may_reach(Vec3 position) const {
        const Vec3 way = position - eye_;
        const double depth = dot(way, forward_);
        const double reach = (1 + 1e-9) * (pixels_ * radius_ + tolerance_ * depth);  // in pixels at depth 1
        return depth > 0 && std::abs(pixels_ * dot(way, right_) - x_ * depth) <= reach &&
               std::abs(pixels_ * dot(way, up_) - y_ * depth) <= reach;
    }

private:
    Vec3 eye_, forward_, right_, up_;
    double pixels_, x_, y_, tolerance_, radius_ = 0;
};

}  // namespace

std::optional<std::size_t> particle_at(const Frame& frame, const DrawnSizes& sizes, const Projection& projection,
                                       PixelPoint pixel, double tolerance) {
    std::optional<std::size_t> under, beside;
    double least_depth = std::numeric_limits<double>::infinity();
    double least_beyond = tolerance;
    const NearPointer near(sizes, projection, pixel, tolerance);
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        if (!near.may_reach(frame.seen(i))) continue;
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
