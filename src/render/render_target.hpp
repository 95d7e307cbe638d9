#pragma once

#include "render/camera.hpp"
#include "render/gl_objects.hpp"
#include "render/picture_texture.hpp"
#include "render/split.hpp"

#include <cstdint>
#include <vector>

namespace steplab::render {

/// The target of drawing: a multisampled framebuffer and the texture that it is resolved to.
class RenderTarget {
public:
    /// Throws GraphicsError if OpenGL does not support the size; the message names the largest one.
    explicit RenderTarget(PictureSize size);

    PictureSize size() const { return size_; }
    /// Samples per pixel; 1 if OpenGL does not support more.
    int samples() const { return samples_; }

    /// Binds the multisampled framebuffer with a viewport of its full size.
    void bind() const;
    /// Binds texture() with a viewport of its full size, for drawing without multisampling.
    void bind_picture() const;
    /// Averages the samples into texture() and binds that.
    void resolve() const { resolve({0, 0, size_}); }
    /// The same of a part of the picture alone.
    void resolve(const PictureArea& area) const;
    /// The framebuffer of texture(), which is the finished picture, bottom row first.
    GLuint framebuffer() const { return framebuffer_.id(); }
    GLuint texture() const { return texture_.name(); }
    /// Gives the finished picture away and draws into the other texture from now on, whose content is lost.
    void exchange(PictureTexture& texture);
    /// The finished picture as bytes: rows from the top, 4 bytes per pixel (red, green, blue, alpha).
    std::vector<std::uint8_t> read() const;
    /// The same as a texture has it, reusing the memory there.
    void copy_into(TexturePixels& pixels) const;

private:
    void read_pixels(GLenum order, std::vector<std::uint8_t>& bytes) const;
    void attach_texture();

    PictureSize size_;
    int samples_;
    Renderbuffer colour_, depth_;
    Framebuffer multisampled_;
    PictureTexture texture_;
    Framebuffer framebuffer_;
};

}  // namespace steplab::render
