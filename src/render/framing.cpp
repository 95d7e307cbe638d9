#include "render/framing.hpp"

#include "core/number_text.hpp"
#include "render/bounds.hpp"
#include "render/drawn_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab::render {
namespace {

// Part of the half picture that the scene may fill; the rest is for the legend, the numbers of the axes and a margin.
constexpr double filled_width = 0.90;
constexpr double filled_height = 0.86;

struct Direction {
    double yaw = 0;
    double pitch = 0;
};

Direction opening_direction(const Shape& shape) {
    const Vec3 size = expected_bounds(shape).size();
    const bool with_bullet = std::find(shape.roles.begin(), shape.roles.end(), Role::bullet) != shape.roles.end();
    if (with_bullet) return {66, 14};  // over what it is shot at, along its path
    const bool upright = size.z <= 0.2 * std::max(size.x, size.y);
    return upright ? Direction{-14, 12} : Direction{30, 32};
}

/// The extent of the scene across the picture, seen from one direction: the largest of across + t ahead and of
/// -across + t ahead over all particles, with t the tangent of half the field of view. Both together give the smallest
/// distance that shows all particles, and the centre of the picture.
struct Reach {
    double tangent = 1;
    double positive = -INFINITY;
    double negative = -INFINITY;

    void include(double across, double ahead, double radius) {
        // A ball touches the edge of the picture with its surface, not with its centre.
        const double round = radius * std::hypot(1.0, tangent);
        positive = std::max(positive, across + tangent * ahead + round);
        negative = std::max(negative, -across + tangent * ahead + round);
    }
    double centre() const { return (positive - negative) / 2; }
    double distance() const { return (positive + negative) / (2 * tangent); }
};

}  // namespace

Camera framed(const Frame& frame, double yaw, double pitch, PictureSize size) {
    const Shape& shape = *frame.shape;
    const DrawnSizes sizes(shape);
    const Vec3 centre = expected_bounds(shape).centre();
    const Projection projection({centre, 1, yaw, pitch}, size);
    Reach wide{filled_width * projection.half_width()};
    Reach high{filled_height * projection.half_height()};
    const auto include = [&](Vec3 point, double radius) {
        if (!drawable(point)) return;
        const Vec3 from = point - centre;
        const double ahead = -dot(from, projection.forward());
        wide.include(dot(from, projection.right()), ahead, radius);
        high.include(dot(from, projection.up()), ahead, radius);
    };
    for (std::size_t i = 0; i < shape.rest.size(); ++i) {
        const double radius = sizes.radius(shape.roles[i]);
        include(shape.rest[i], radius);
        include(frame.seen(i), radius);
    }
    // The axes have to be in the picture, too.
    for (const Vec3& corner : axes_box(frame).bounds.corners()) include(corner, 0);
    const double closest = 4 * shape.spacing;  // a single particle does not fill the picture
    const double distance = std::max({wide.distance(), high.distance(), closest});
    return {centre + wide.centre() * projection.right() + high.centre() * projection.up(),
            std::clamp(distance, least_distance, largest_length), yaw, pitch};
}

ZoomLimits zoom_limits(const Frame& frame) {
    constexpr double of_radius = 0.1, of_scene = 100, resolution = 1e-14;
    const Shape& shape = *frame.shape;
    const double ball = DrawnSizes(shape).radius(Role::moving);
    const Bounds box = axes_box(frame).bounds;
    const double place = std::max(length(box.low), length(box.high));
    const double nearest = std::clamp(std::max(of_radius * ball, resolution * place), least_distance, largest_length);
    const double scene = std::max(length(box.size()), shape.spacing);
    return {nearest, std::clamp(of_scene * scene, nearest, largest_length)};
}

Camera default_camera(const Frame& frame, PictureSize size) {
    const Direction direction = opening_direction(*frame.shape);
    return framed(frame, direction.yaw, direction.pitch, size);
}

std::string view_text(const Camera& camera) {
    return fmt::format("{},{},{},{},{},{}", number_text(camera.yaw), number_text(camera.pitch),
                       number_text(camera.distance), number_text(camera.focus.x), number_text(camera.focus.y),
                       number_text(camera.focus.z));
}

Camera camera_of(std::string_view text, const Frame& frame, PictureSize size) {
    const WrittenView view = parse_view(text, "--view");
    if (view.word == "default") return default_camera(frame, size);
    if (view.word == "front") return framed(frame, 0, 0, size);
    if (view.word == "side") return framed(frame, 90, 0, size);
    if (view.word == "top") return framed(frame, 0, 90, size);
    return {view.focus, view.distance, view.yaw, view.pitch};
}

}  // namespace steplab::render
