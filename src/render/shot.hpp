#pragma once

#include "core/frame.hpp"
#include "render/camera.hpp"
#include "render/colouring.hpp"
#include "render/known_shape.hpp"
#include "render/scene_renderer.hpp"
#include "render/style.hpp"

#include <optional>

namespace steplab::render {

/// What one picture, or a tile of it, is made of.
struct Shot {
    const Frame& frame;
    const KnownShape& known;  ///< of the frame
    const Style& style;
    const std::optional<ColourScale>& scale;
    const Projection& projection;
    const Tile& tile;
    PictureSize part;  ///< what the tile holds of the whole
};

}  // namespace steplab::render
