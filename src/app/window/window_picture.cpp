#include "app/window/window_picture.hpp"

#include "render/render_target.hpp"

#include <imgui.h>

namespace steplab {
namespace {

render::PictureArea picture_area(const ui::PixelRect& rect) { return {rect.x, rect.y, {rect.width, rect.height}}; }

}  // namespace

void WindowPicture::upload_fonts(ImFontAtlas& fonts) {
    panels_.upload_fonts(fonts);
    kept_.forget_panels();
}

bool WindowPicture::draw(const render::PictureTexture& scene, const ui::PixelRect& area, const ImDrawData& panels) {
    if (kept_.draw(scene, picture_area(area), panels, panels_) == 0) return false;
    repeat();
    return true;
}

void WindowPicture::repeat() const {
    const auto [width, height] = kept_.size();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, kept_.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Picture WindowPicture::read(const Shot& shot) const {
    const ui::PixelRect& part = shot.part;
    const render::PictureSize size{part.width, part.height + shot.caption_height};
    const render::RenderTarget target(size);
    target.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    target.resolve();
    const ui::PixelRect area{shot.area.x - part.x, shot.area.y - part.y, shot.area.width, shot.area.height};
    const render::PictureArea all[] = {{0, 0, size}};
    kept_.copy_scene(shot.scene, picture_area(area), target.framebuffer(), size.height, all);
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
