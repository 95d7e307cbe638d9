#pragma once

#include "core/frame.hpp"
#include "render/camera.hpp"
#include "render/colouring.hpp"
#include "render/known_shape.hpp"
#include "render/scene_renderer.hpp"
#include "render/style.hpp"

#include <optional>

namespace steplab::render {

/// The input of one picture, or of a tile of it.
struct Shot {
    const Frame& frame;
    const KnownShape& known;  ///< shape of the frame
    const Style& style;
    const std::optional<ColourScale>& scale;
    const Projection& projection;
    const Tile& tile;
    PictureSize part;  ///< size of the tile
};

}  // namespace steplab::render
