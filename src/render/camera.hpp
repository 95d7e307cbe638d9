#pragma once

#include "core/appearance.hpp"
#include "core/vec3.hpp"

#include <optional>

namespace steplab::render {

/// The position and direction of the camera. At yaw 0 and pitch 0 it points along -z, with x to the right and y up.
struct Camera {
    Vec3 focus;            ///< the point at the centre of the picture, about which the camera turns
    double distance = 10;  ///< from the camera to the focus, > 0
    double yaw = 0;        ///< degrees; the camera moves towards +x as it grows
    double pitch = 0;      ///< degrees, -90 .. 90; the camera moves up as it grows

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Vertical field of view in degrees.
inline constexpr double field_of_view = 28;

/// Size of a picture in pixels.
struct PictureSize {
    int width = 1280;
    int height = 720;
    friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// A point of a picture in pixels from its top left corner, the centre of the first pixel at (0.5, 0.5).
struct PixelPoint {
    double x = 0;
    double y = 0;
};

struct Ray {
    Vec3 origin;
    Vec3 direction;  ///< of length 1
};

/// A camera and a picture size: maps points in space to pixels and back, in double.
class Projection {
public:
    Projection(const Camera& camera, PictureSize size);

    const Camera& camera() const { return camera_; }
    PictureSize size() const { return size_; }
    Vec3 eye() const { return eye_; }
    Vec3 right() const { return right_; }
    Vec3 up() const { return up_; }
    Vec3 forward() const { return forward_; }
    /// Distance of a point in front of the camera along its direction; negative behind it.
    double depth(Vec3 point) const { return dot(point - eye_, forward_); }
    /// The place of a point in the picture, also beyond its edges. None if it is not in front of the camera.
    std::optional<PixelPoint> pixel(Vec3 point) const;
    /// The ray from the camera through a pixel.
    Ray ray(PixelPoint pixel) const;
    /// The point under a pixel on the plane through the focus that faces the camera.
    Vec3 on_focus_plane(PixelPoint pixel) const;
    /// Pixels covered by a length of 1 at a depth > 0.
    double pixels_per_unit(double depth) const { return pixels_at_one_ / depth; }
    /// Tangents of half the horizontal and vertical field of view.
    double half_width() const { return half_width_; }
    double half_height() const { return half_height_; }

private:
    Camera camera_;
    PictureSize size_;
    Vec3 right_, up_, forward_, eye_;
    double half_width_, half_height_, pixels_at_one_;
};

/// Turns about the focus by a drag of the mouse in pixels; the height of the picture is half a turn.
Camera orbited(const Projection& projection, double dx, double dy);
/// Moves so that the focus follows a drag of the mouse in pixels.
Camera panned(const Projection& projection, double dx, double dy);
/// The distances of a camera from its focus between which it can be zoomed.
struct ZoomLimits {
    double nearest = least_distance;
    double farthest = largest_length;
};
/// Moves closer by `factor` (> 1) or away (< 1), within the limits; the point of the focus plane under the pixel stays
/// there.
Camera zoomed(const Projection& projection, double factor, PixelPoint pixel, const ZoomLimits& limits = {});

}  // namespace steplab::render
