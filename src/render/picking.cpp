#include "render/picking.hpp"

#include "render/bounds.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::render {

std::optional<std::size_t> particle_at(const Frame& frame, const Projection& projection, PixelPoint pixel,
                                       double reach) {
    std::optional<std::size_t> nearest;
    double nearest_depth = 0;
    const DrawnSizes sizes(*frame.shape);
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        const Vec3 position = frame.seen(i);
        if (!drawable(position)) continue;
        const double depth = projection.depth(position);
        const auto centre = projection.pixel(position);
        if (!centre || (nearest && depth >= nearest_depth)) continue;
        const double radius = sizes.radius(frame.shape->roles[i]) * projection.pixels_per_unit(depth);
        if (std::hypot(centre->x - pixel.x, centre->y - pixel.y) > std::max(radius, reach)) continue;
        nearest = i;
        nearest_depth = depth;
    }
    return nearest;
}

}  // namespace steplab::render
