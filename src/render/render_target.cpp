#include "render/render_target.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace steplab::render {
namespace {

constexpr int wanted_samples = 4;

int integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

void make_storage(const Renderbuffer& buffer, GLenum format, int samples, PictureSize size) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.width, size.height);
}

void require_complete(PictureSize size) {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE && glGetError() == GL_NO_ERROR) return;
    throw GraphicsError(fmt::format("OpenGL cannot create a picture of {}x{} pixels", size.width, size.height));
}

void require_size(PictureSize size) {
    const int largest = std::min(integer(GL_MAX_RENDERBUFFER_SIZE), integer(GL_MAX_TEXTURE_SIZE));
    const bool possible = size.width >= 1 && size.height >= 1 && size.width <= largest && size.height <= largest;
    if (possible) return;
    throw GraphicsError(fmt::format("a picture must have at most {}x{} pixels with this OpenGL (got {}x{})", largest,
                                    largest, size.width, size.height));
}

}  // namespace

RenderTarget::RenderTarget(PictureSize size) : size_(size) {
    samples_ = std::clamp(integer(GL_MAX_SAMPLES), 1, wanted_samples);
    require_size(size);
    while (glGetError() != GL_NO_ERROR) {
    }
    make_storage(colour_, GL_RGBA8, samples_, size);
    make_storage(depth_, GL_DEPTH_COMPONENT24, samples_, size);
    glBindFramebuffer(GL_FRAMEBUFFER, multisampled_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
    require_complete(size);
    attach_texture();
    require_complete(size);
}

void RenderTarget::attach_texture() {
    texture_.reserve(size_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
}

void RenderTarget::exchange(PictureTexture& texture) {
    std::swap(texture_, texture);
    attach_texture();
}

void RenderTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, multisampled_.id());
    glViewport(0, 0, size_.width, size_.height);
}

void RenderTarget::bind_picture() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, size_.width, size_.height);
}

void RenderTarget::resolve(const PictureArea& area) const {
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, multisampled_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.id());
    const int left = area.left, right = left + area.size.width;
    const int top = size_.height - area.top, bottom = top - area.size.height;
    glBlitFramebuffer(left, bottom, right, top, left, bottom, right, top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
}

/// Rows from the bottom, of pixels in this order.
void RenderTarget::read_pixels(GLenum order, std::vector<std::uint8_t>& bytes) const {
    bytes.resize(4 * static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_.width, size_.height, order, GL_UNSIGNED_BYTE, bytes.data());
}

void RenderTarget::copy_into(TexturePixels& pixels) const {
    pixels.size = size_;
    read_pixels(GL_BGRA, pixels.bytes);
}

std::vector<std::uint8_t> RenderTarget::read() const {
    std::vector<std::uint8_t> bytes;
    read_pixels(GL_RGBA, bytes);
    const std::size_t row = 4 * static_cast<std::size_t>(size_.width);
    for (std::size_t top = 0, bottom = static_cast<std::size_t>(size_.height) - 1; top < bottom; ++top, --bottom) {
        const auto upper = bytes.begin() + static_cast<std::ptrdiff_t>(top * row);
        const auto lower = bytes.begin() + static_cast<std::ptrdiff_t>(bottom * row);
        std::swap_ranges(upper, upper + static_cast<std::ptrdiff_t>(row), lower);
    }
    return bytes;
}

}  // namespace steplab::render
