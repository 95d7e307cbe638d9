#include "app/window/window_picture.hpp"

#include "app/png.hpp"
#include "io/output_file.hpp"
#include "render/render_target.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace steplab {
namespace {

render::PictureSize size_of(const ImDrawData& panels) {
    return {static_cast<int>(panels.DisplaySize.x), static_cast<int>(panels.DisplaySize.y)};
}

/// The rows of a part of a picture, 4 bytes per pixel.
std::vector<std::uint8_t> cut_out(const std::vector<std::uint8_t>& picture, int width, const ui::PixelRect& part) {
    std::vector<std::uint8_t> bytes;
    for (int row = part.y; row < part.y + part.height; ++row) {
        const auto begin = picture.begin() + 4 * (static_cast<std::ptrdiff_t>(row) * width + part.x);
        bytes.insert(bytes.end(), begin, begin + 4 * static_cast<std::ptrdiff_t>(part.width));
    }
    return bytes;
}

}  // namespace

void WindowPicture::draw(const render::PictureTexture& scene, const ui::PixelRect& area,
                         const ImDrawData& panels) const {
    const render::PictureSize size = size_of(panels);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.width, size.height);
    copy_scene(scene, area, size.height, 0);
    panels_.draw(panels);
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

void WindowPicture::save(const render::PictureTexture& scene, const ui::PixelRect& area, const ImDrawData& panels,
                         const ui::PixelRect& part, const std::string& file) const {
    const render::PictureSize size = size_of(panels);
    const render::RenderTarget target(size);
    target.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    target.resolve();
    copy_scene(scene, area, size.height, target.framebuffer());
    panels_.draw(panels);
    ui::PixelRect shown = part.width > 0 ? part : ui::PixelRect{0, 0, size.width, size.height};
    shown.width = std::min(shown.width, size.width - shown.x);
    shown.height = std::min(shown.height, size.height - shown.y);
    OutputFile out(file);
    out.write(encode_png(shown.width, shown.height, cut_out(target.read(), size.width, shown)));
    out.commit();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace steplab
