#include "app/window/picture.hpp"

#include "app/png.hpp"
#include "io/output_file.hpp"
#include "render/render_target.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace steplab {
namespace {

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

void write_panels(const render::ImguiRenderer& renderer, const ImDrawData& data, render::PictureSize size,
                  const ui::PixelRect& part, const std::string& file) {
    const render::RenderTarget target(size);
    target.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    target.resolve();
    renderer.draw(data);
    ui::PixelRect shown = part.width > 0 ? part : ui::PixelRect{0, 0, size.width, size.height};
    shown.width = std::min(shown.width, size.width - shown.x);
    shown.height = std::min(shown.height, size.height - shown.y);
    OutputFile out(file);
    out.write(encode_png(shown.width, shown.height, cut_out(target.read(), size.width, shown)));
    out.commit();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace steplab
