#include "app/window/window_picture.hpp"

#include "render/render_target.hpp"

#include <imgui.h>

#include <span>
#include <vector>

namespace steplab {
namespace {

render::PictureSize size_of(const ImDrawData& panels) {
    return {static_cast<int>(panels.DisplaySize.x), static_cast<int>(panels.DisplaySize.y)};
}

/// What panels cover, in the bound framebuffer.
void clear(std::span<const render::PictureArea> areas, int height) {
    glClearColor(0, 0, 0, 1);
    glEnable(GL_SCISSOR_TEST);
    for (const auto& [left, top, size] : areas) {
        glScissor(left, height - top - size.height, size.width, size.height);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace

void WindowPicture::upload_fonts(ImFontAtlas& fonts) {
    panels_.upload_fonts(fonts);
    changes_.forget();
}

bool WindowPicture::draw(const render::PictureTexture& scene, const ui::PixelRect& area, const ImDrawData& panels) {
    const render::PictureSize size = size_of(panels);
    if (kept_.size() != size) {
        kept_.reserve(size);
        glBindFramebuffer(GL_FRAMEBUFFER, kept_framebuffer_.id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, kept_.name(), 0);
        changes_.forget();
    }
    const bool has_scene = scene.size().width > 0;
    if (!has_scene) changes_.forget();
    const render::PictureArea covered{area.x, area.y, {area.width, area.height}};
    std::vector<render::PictureArea> areas =
        changes_.take(panels, has_scene ? covered : render::PictureArea{0, 0, {0, 0}});
    if (!changes_.differs() && scene_area_ == area) return false;
    scene_area_ = area;
    glBindFramebuffer(GL_FRAMEBUFFER, kept_framebuffer_.id());
    clear(areas, size.height);
    if (has_scene) {
        copy_scene(scene, area, size.height, kept_framebuffer_.id());
        areas.push_back(covered);
    }
    panels_.draw(panels, areas);
    show(size);
    return true;
}

void WindowPicture::show(render::PictureSize size) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, kept_framebuffer_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

/// A copy of pixels, which needs no blending: as part of the panels the scene would cost as much as all of them.
void WindowPicture::copy_scene(const render::PictureTexture& scene, const ui::PixelRect& area, int height,
                               GLuint to) const {
    const auto [width, rows] = scene.size();
    if (width == 0) return;  // not drawn yet
    const bool same = width == area.width && rows == area.height;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, scene_.id());
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, scene.name(), 0);
    const int bottom = height - area.y - area.height;
    glBlitFramebuffer(0, 0, width, rows, area.x, bottom, area.x + area.width, bottom + area.height, GL_COLOR_BUFFER_BIT,
                      same ? GL_NEAREST : GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, to);
}

Picture WindowPicture::read(const Shot& shot) const {
    const ui::PixelRect& part = shot.part;
    const render::PictureSize size{part.width, part.height + shot.caption_height};
    const render::RenderTarget target(size);
    target.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    target.resolve();
    const ui::PixelRect area{shot.area.x - part.x, shot.area.y - part.y, shot.area.width, shot.area.height};
    copy_scene(shot.scene, area, size.height, target.framebuffer());
    if (shot.panels) {
        ImDrawData panels = *shot.panels;
        panels.DisplayPos = {static_cast<float>(part.x), static_cast<float>(part.y)};
        panels.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
        panels_.draw(panels);
    }
    if (shot.caption) shot.caption->draw();
    Picture picture{size, target.read()};
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return picture;
}

}  // namespace steplab
