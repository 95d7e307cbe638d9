#include "render/picture_texture.hpp"

namespace steplab::render {

void PictureTexture::reserve(PictureSize size) {
    if (size_ == size) return;
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    // In the byte order that windows have: a picture is then copied into one as it is.
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_BGRA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    size_ = size;
}

void PictureTexture::upload(PictureSize size, std::span<const std::uint8_t> rgba) { upload(size, rgba, GL_RGBA); }

void PictureTexture::upload(const TexturePixels& pixels) { upload(pixels.size, pixels.bytes, GL_BGRA); }

void PictureTexture::upload(PictureSize size, std::span<const std::uint8_t> bytes, GLenum order) {
    reserve(size);
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.width, size.height, order, GL_UNSIGNED_BYTE, bytes.data());
}

}  // namespace steplab::render
