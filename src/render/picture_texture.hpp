#pragma once

#include "render/camera.hpp"
#include "render/gl_objects.hpp"

#include <cstdint>
#include <span>

namespace steplab::render {

/// A texture that holds a picture.
class PictureTexture {
public:
    /// Makes it of this size. Its content is lost if it had another one.
    void reserve(PictureSize size);
    /// `rgba`: 4 bytes a pixel, in the order of the rows of the texture.
    void upload(PictureSize size, std::span<const std::uint8_t> rgba);

    GLuint name() const { return texture_.id(); }
    /// 0 x 0 until it has one.
    PictureSize size() const { return size_; }

private:
    Texture texture_;
    PictureSize size_{0, 0};
};

}  // namespace steplab::render
