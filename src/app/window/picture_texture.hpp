#pragma once

#include "render/camera.hpp"
#include "render/gl_objects.hpp"

#include <cstdint>
#include <span>

namespace steplab {

/// A picture as a texture of the current context.
class PictureTexture {
public:
    /// `rgba`: rows from the top, 4 bytes a pixel.
    void upload(render::PictureSize size, std::span<const std::uint8_t> rgba);
    std::uint32_t name() const { return texture_.id(); }

private:
    render::Texture texture_;
    render::PictureSize size_{0, 0};
};

}  // namespace steplab
