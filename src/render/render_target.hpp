#pragma once

#include "render/camera.hpp"
#include "render/gl_objects.hpp"

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace steplab::render {

/// The picture that is drawn into: a multisampled framebuffer and the texture it is resolved to.
class RenderTarget {
public:
    /// Throws GraphicsError if this OpenGL cannot make it; the message tells the largest size.
    /// `supersampling` 2 draws at twice the width and height and averages: finer edges at four times the cost.
    explicit RenderTarget(PictureSize size, int supersampling = 1);

    PictureSize size() const { return size_; }
    int supersampling() const { return supersampling_; }
    /// Where the samples of a pixel of the multisampled framebuffer lie, from its centre, in pixels.
    std::span<const glm::vec2> sample_places() const { return sample_places_; }

    /// Makes the multisampled framebuffer the one drawn into, its viewport the whole of it.
    void bind() const;
    /// Averages the samples into texture(), and makes that the one drawn into, for what needs no smoothing (text).
    void resolve() const;
    /// The finished picture, bottom row first.
    GLuint texture() const { return texture_.id(); }
    /// The finished picture as bytes: rows from the top, 4 bytes a pixel (red, green, blue, alpha).
    std::vector<std::uint8_t> read() const;

private:
    /// What is drawn at `supersampling` times the size is averaged twice, by way of this.
    struct Intermediate {
        Texture texture;
        Framebuffer framebuffer;
    };

    PictureSize size_;
    int supersampling_;
    std::vector<glm::vec2> sample_places_;
    Renderbuffer colour_, depth_;
    Framebuffer multisampled_;
    std::optional<Intermediate> intermediate_;
    Texture texture_;
    Framebuffer framebuffer_;
};

}  // namespace steplab::render
