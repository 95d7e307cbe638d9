#include "render/kept_picture.hpp"

#include <imgui.h>

#include <vector>

namespace steplab::render {
namespace {

/// Does it once for each area, in which alone it draws.
template <class Draw>
void in_each(std::span<const PictureArea> areas, int height, const Draw& draw) {
    glEnable(GL_SCISSOR_TEST);
    for (const auto& [left, top, size] : areas) {
        glScissor(left, height - top - size.height, size.width, size.height);
        draw();
    }
    glDisable(GL_SCISSOR_TEST);
}

std::vector<PictureArea> parts_within(const PictureArea& whole, std::span<const PictureArea> areas) {
    std::vector<PictureArea> parts;
    for (const PictureArea& area : areas) {
        if (const auto part = shared_part(area, whole)) parts.push_back(*part);
    }
    return parts;
}

int pixels_in(std::span<const PictureArea> areas) {
    int sum = 0;
    for (const PictureArea& area : areas) sum += area.size.width * area.size.height;
    return sum;
}

}  // namespace

void KeptPicture::resize(PictureSize size) {
    if (kept_.size() == size) return;
    kept_.reserve(size);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, kept_.name(), 0);
}

int KeptPicture::draw(const PictureTexture& scene, const PictureArea& area, const ImDrawData& panels,
                      const ImguiRenderer& renderer) {
    resize({static_cast<int>(panels.DisplaySize.x), static_cast<int>(panels.DisplaySize.y)});
    const bool has_scene = scene.size().width > 0;
    const bool other_scene = has_scene && scene_area_ != area;
    std::vector<PictureArea> areas = changes_.take(panels, other_scene ? area : PictureArea{0, 0, {0, 0}});
    if (other_scene) areas.push_back(area);
    if (areas.empty()) return 0;
    scene_area_ = area;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer());
    glClearColor(0, 0, 0, 1);
    in_each(areas, size().height, [] { glClear(GL_COLOR_BUFFER_BIT); });
    if (has_scene) copy_scene(scene, area, framebuffer(), size().height, areas);
    renderer.draw(panels, areas);
    return pixels_in(areas);
}

/// A copy of pixels, which needs no blending: as part of the panels the scene would cost as much as all of them.
void KeptPicture::copy_scene(const PictureTexture& scene, const PictureArea& area, GLuint to, int height,
                             std::span<const PictureArea> parts) const {
    const PictureSize from = scene.size();
    if (from.width == 0) return;  // not drawn yet
    glBindFramebuffer(GL_READ_FRAMEBUFFER, scene_.id());
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, scene.name(), 0);
    const int right = area.left + area.size.width, bottom = height - area.top - area.size.height;
    in_each(parts_within(area, parts), height, [&] {
        glBlitFramebuffer(0, 0, from.width, from.height, area.left, bottom, right, bottom + area.size.height,
                          GL_COLOR_BUFFER_BIT, from == area.size ? GL_NEAREST : GL_LINEAR);
    });
    glBindFramebuffer(GL_FRAMEBUFFER, to);
}

}  // namespace steplab::render
