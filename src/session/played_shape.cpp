#include "session/played_shape.hpp"

#include "core/error.hpp"
#include "models/scene/mean_nearest.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace steplab {

namespace {

/// Two corners of the box around the points that are numbers; nothing without one.
void add_box(std::span<const Vec3> points, std::vector<Vec3>& corners) {
    Vec3 low{INFINITY, INFINITY, INFINITY}, high = -1.0 * low;
    for (const Vec3 point : points) {
        if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) continue;
        low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
    }
    if (low.x <= high.x) corners.insert(corners.end(), {low, high});
}

/// Frames of the middle and of the end; one that is damaged is empty, which is told when it is gone to.
std::vector<Frame> later_frames(PlayedFrames& frames) {
    std::vector<Frame> later(2);
    for (std::size_t i = 0; i < later.size(); ++i) {
        try {
            frames.frame((frames.frames() - 1) * (i + 1) / 2, later[i]);
        } catch (const FileError&) {
            later[i] = {};
        }
    }
    return later;
}

}  // namespace

std::shared_ptr<const Shape> played_shape(PlayedFrames& frames, const Frame& first) {
    constexpr std::size_t most_rows = 1'000'000;
    Shape shape = *first.shape;
    shape.rest = shape.expected = first.positions;
    if (first.positions.size() <= most_rows) {
        for (const Frame& frame : later_frames(frames)) add_box(frame.positions, shape.expected);
    }
    shape.roles.resize(first.positions.size(), Role::moving);
    const double apart = mean_nearest(first.positions);
    shape.spacing = apart > 0 ? apart : 1;
    return std::make_shared<const Shape>(std::move(shape));
}

}  // namespace steplab
