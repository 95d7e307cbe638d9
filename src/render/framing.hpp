#pragma once

#include "core/frame.hpp"
#include "render/camera.hpp"

#include <string>
#include <string_view>

namespace steplab::render {

/// The camera that a scene opens with: it shows the whole scene and the places that it is expected to reach. Lines are
/// seen from the front, plates and clusters obliquely from above.
Camera default_camera(const Frame& frame, PictureSize size);

/// The closest camera in this direction that shows every particle of the frame and of the scene at rest.
Camera framed(const Frame& frame, double yaw, double pitch, PictureSize size);

/// From a part of a ball's radius, or from what doubles resolve where the scene is, to where the scene is still some
/// pixels across.
ZoomLimits zoom_limits(const Frame& frame);

/// A camera as text: "yaw,pitch,distance,x,y,z" with angles in degrees and the focus x,y,z. The numbers read back
/// exactly.
std::string view_text(const Camera& camera);

/// The camera for `text`: the form of view_text() or one of the words default, front, side, top. Throws UsageError that
/// describes the valid forms.
Camera camera_of(std::string_view text, const Frame& frame, PictureSize size);

}  // namespace steplab::render
