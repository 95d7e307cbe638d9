#include "render/underlay.hpp"

#include <utility>

namespace steplab::render {
namespace {

/// From one framebuffer to another of the same height, at the same place.
void copy(const PictureArea& area, int height, GLuint from, GLuint to) {
    const int left = area.left, right = left + area.size.width, top = height - area.top,
              bottom = top - area.size.height;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(left, bottom, right, top, left, bottom, right, top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace

Underlay::Underlay() : program_("backdrop.vert", "underlay.frag", shader_folders()) {}

bool Underlay::repeat(std::size_t run, const Look& look, const RenderTarget& target) {
    if (picture_.size() != target.size() || kept_[run] != look) return false;
    copy(look.port, target.size().height, framebuffer_.id(), target.framebuffer());
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    return true;
}

void Underlay::keep(std::size_t run, const Look& look, const RenderTarget& target) {
    if (std::exchange(drawn_[run], look) != look) return;  // a camera that moves would have it copied for nothing
    if (picture_.size() != target.size()) {
        kept_ = {};
        picture_.reserve(target.size());
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_.name(), 0);
    }
    forget_below(look.port);
    copy(look.port, target.size().height, target.framebuffer(), framebuffer_.id());
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    kept_[run] = look;
}

/// What another run had there, in another layout of the runs.
void Underlay::forget_below(const PictureArea& port) {
    for (std::optional<Look>& other : kept_) {
        if (other && shared_part(other->port, port)) other.reset();
    }
}

void Underlay::draw_into_samples(const RenderTarget& target) const {
    program_.use();
    program_.set("u_picture", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, target.texture());
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace steplab::render
