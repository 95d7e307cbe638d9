#include "render/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steplab::render {
namespace {

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }

double bounded(double coordinate) { return std::clamp(coordinate, -largest_length, largest_length); }

Vec3 bounded(Vec3 focus) { return {bounded(focus.x), bounded(focus.y), bounded(focus.z)}; }

}  // namespace

Projection::Projection(const Camera& camera, PictureSize size) : camera_(camera), size_(size) {
    const double yaw = radians(camera.yaw);
    const double pitch = radians(camera.pitch);
    right_ = {std::cos(yaw), 0, -std::sin(yaw)};
    forward_ = {-std::sin(yaw) * std::cos(pitch), -std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
    up_ = cross(right_, forward_);
    eye_ = camera.focus - camera.distance * forward_;
    half_height_ = std::tan(radians(field_of_view / 2));
    half_width_ = half_height_ * size.width / size.height;
    pixels_at_one_ = size.height / (2 * half_height_);
}

std::optional<PixelPoint> Projection::pixel(Vec3 point) const {
    const double ahead = depth(point);
    if (!(ahead > 0)) return std::nullopt;
    const Vec3 seen = point - eye_;
    const double scale = pixels_per_unit(ahead);
    return PixelPoint{size_.width / 2.0 + scale * dot(seen, right_), size_.height / 2.0 - scale * dot(seen, up_)};
}

Ray Projection::ray(PixelPoint pixel) const {
    const double x = (pixel.x - size_.width / 2.0) / pixels_at_one_;
    const double y = (size_.height / 2.0 - pixel.y) / pixels_at_one_;
    const Vec3 direction = forward_ + x * right_ + y * up_;
    return {eye_, (1 / length(direction)) * direction};
}

Vec3 Projection::on_focus_plane(PixelPoint pixel) const {
    const double scale = 1 / pixels_per_unit(camera_.distance);
    return camera_.focus + scale * (pixel.x - size_.width / 2.0) * right_ +
           scale * (size_.height / 2.0 - pixel.y) * up_;
}

Camera orbited(const Projection& projection, double dx, double dy) {
    Camera camera = projection.camera();
    const double degrees_per_pixel = 180.0 / projection.size().height;
    camera.yaw = std::remainder(camera.yaw - dx * degrees_per_pixel, 360.0);
    camera.pitch = std::clamp(camera.pitch + dy * degrees_per_pixel, -90.0, 90.0);
    return camera;
}

Camera panned(const Projection& projection, double dx, double dy) {
    Camera camera = projection.camera();
    const double scale = 1 / projection.pixels_per_unit(camera.distance);
    camera.focus = bounded(camera.focus - scale * dx * projection.right() + scale * dy * projection.up());
    return camera;
}

Camera zoomed(const Projection& projection, double factor, PixelPoint pixel, const ZoomLimits& limits) {
    Camera camera = projection.camera();
    const double distance = std::clamp(camera.distance / factor, limits.nearest, limits.farthest);
    const Vec3 kept = projection.on_focus_plane(pixel);
    camera.focus = bounded(kept + (distance / camera.distance) * (camera.focus - kept));
    camera.distance = distance;
    return camera;
}

}  // namespace steplab::render
