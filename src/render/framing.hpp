#pragma once

#include "core/frame.hpp"
#include "render/camera.hpp"

#include <string>
#include <string_view>

namespace steplab::render {

/// The camera a scene opens with: whole and well placed, with room for where it is expected to move. Lines are seen
/// from the front, plates and clusters from above at an angle.
Camera default_camera(const Frame& frame, PictureSize size);

/// The nearest camera from this direction that has every particle of the frame, and of the scene at rest, in the
/// picture.
Camera framed(const Frame& frame, double yaw, double pitch, PictureSize size);

/// A camera as text: "yaw,pitch,distance,x,y,z", the angles in degrees, x,y,z the focus. The numbers read back exactly.
std::string view_text(const Camera& camera);

/// The camera that `text` stands for: what view_text() writes, or one of the words default, front, side, top.
/// Throws UsageError that says what would be right.
Camera camera_of(std::string_view text, const Frame& frame, PictureSize size);

}  // namespace steplab::render
