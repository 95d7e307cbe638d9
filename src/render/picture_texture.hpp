#pragma once

#include "render/camera.hpp"
#include "render/gl_objects.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace steplab::render {

/// A picture as it lies in a PictureTexture, which drivers copy as it is: rows from the bottom, 4 bytes a pixel (blue,
/// green, red, alpha).
struct TexturePixels {
    PictureSize size{0, 0};
    std::vector<std::uint8_t> bytes = {};
};

/// A texture that holds a picture.
class PictureTexture {
public:
    /// Makes it of this size. Its content is lost if it had another one.
    void reserve(PictureSize size);
    /// `rgba`: 4 bytes a pixel, in the order of the rows of the texture.
    void upload(PictureSize size, std::span<const std::uint8_t> rgba);
    void upload(const TexturePixels& pixels);

    GLuint name() const { return texture_.id(); }
    /// 0 x 0 until it has one.
    PictureSize size() const { return size_; }

private:
    void upload(PictureSize size, std::span<const std::uint8_t> bytes, GLenum order);

    Texture texture_;
    PictureSize size_{0, 0};
};

}  // namespace steplab::render
