#pragma once

#include "render/gl_objects.hpp"
#include "render/imgui_renderer.hpp"
#include "render/picture_texture.hpp"
#include "ui/display.hpp"

#include <string>

struct ImDrawData;
struct ImFontAtlas;

namespace steplab {

/// What the window shows: the picture of the scene and the panels over it.
class WindowPicture {
public:
    /// To be called when the fonts of the interface were built again.
    void upload_fonts(ImFontAtlas& fonts) { panels_.upload_fonts(fonts); }
    /// Draws it in the window. The scene is stretched to its area where its picture has another size.
    void draw(const render::PictureTexture& scene, const ui::PixelRect& area, const ImDrawData& panels) const;
    /// Writes it, or `part` of it if that is not empty, as a PNG. Throws FileError, GraphicsError.
    void save(const render::PictureTexture& scene, const ui::PixelRect& area, const ImDrawData& panels,
              const ui::PixelRect& part, const std::string& file) const;

private:
    /// Copies the scene into the framebuffer of this name.
    void copy_scene(const render::PictureTexture& scene, const ui::PixelRect& area, int height, GLuint to) const;

    render::ImguiRenderer panels_;
    render::Framebuffer scene_;
};

}  // namespace steplab
