#pragma once

#include "render/camera.hpp"
#include "render/gl_objects.hpp"

#include <cstdint>
#include <vector>

namespace steplab::render {

/// The picture that is drawn into: a multisampled framebuffer and the texture it is resolved to.
class RenderTarget {
public:
    /// Throws GraphicsError if this OpenGL cannot make it; the message tells the largest size.
    explicit RenderTarget(PictureSize size);

    PictureSize size() const { return size_; }
    /// Samples of a pixel; 1 where this OpenGL has no more.
    int samples() const { return samples_; }

    /// Makes the multisampled framebuffer the one drawn into, its viewport the whole of it.
    void bind() const;
    /// Averages the samples into texture(), and makes that the one drawn into, for what needs no smoothing (text).
    void resolve() const;
    /// The finished picture, bottom row first.
    GLuint texture() const { return texture_.id(); }
    /// The finished picture as bytes: rows from the top, 4 bytes a pixel (red, green, blue, alpha).
    std::vector<std::uint8_t> read() const;

private:
    PictureSize size_;
    int samples_;
    Renderbuffer colour_, depth_;
    Framebuffer multisampled_;
    Texture texture_;
    Framebuffer framebuffer_;
};

}  // namespace steplab::render
