#pragma once

#include "render/bounds.hpp"
#include "render/camera.hpp"
#include "render/split.hpp"

namespace steplab::render {

/// The part of a picture that shows a box, wider by a margin in pixels; none if it is outside. All of the picture where
/// the box is beside the camera or behind it.
std::optional<PictureArea> seen_area(const Bounds& box, const Projection& projection, double margin);

}  // namespace steplab::render
