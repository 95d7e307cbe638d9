#include "render/seen_area.hpp"

#include "core/clamped.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::render {

std::optional<PictureArea> seen_area(const Bounds& box, const Projection& projection, double margin) {
    const PictureSize size = projection.size();
    const PictureArea all{0, 0, size};
    PixelPoint low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
    for (const Vec3& corner : box.corners()) {
        const auto pixel = projection.pixel(corner);
        if (!pixel || !std::isfinite(pixel->x + pixel->y)) return all;
        low = {std::min(low.x, pixel->x), std::min(low.y, pixel->y)};
        high = {std::max(high.x, pixel->x), std::max(high.y, pixel->y)};
    }
    const int left = clamped_floor(low.x - margin, 0, size.width), top = clamped_floor(low.y - margin, 0, size.height);
    const int right = clamped_floor(high.x + margin + 1, 0, size.width);
    const int bottom = clamped_floor(high.y + margin + 1, 0, size.height);
    return shared_part(all, {left, top, {right - left, bottom - top}});
}

}  // namespace steplab::render
