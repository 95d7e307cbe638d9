#pragma once

#include "app/offscreen/module.hpp"
#include "app/window/caption_strip.hpp"
#include "render/imgui_renderer.hpp"
#include "render/kept_picture.hpp"
#include "render/picture_texture.hpp"
#include "ui/display.hpp"

struct ImDrawData;
struct ImFontAtlas;

namespace steplab {

/// What the window shows: the picture of the scene and the panels over it.
class WindowPicture {
public:
    /// To be called when the fonts of the interface were built again.
    void upload_fonts(ImFontAtlas& fonts);
    /// To be called when another texture of the panels has other content.
    void forget_panels() { kept_.forget_panels(); }
    /// To be called when the scene has another picture.
    void forget_scene() { kept_.forget_scene(); }
    /// Draws it in the window unless it looks as it did: false, then. The scene is stretched to its area where its
    /// picture has another size.
    bool draw(const render::PictureTexture& scene, const ui::PixelRect& area, const ImDrawData& panels);
    /// Draws it as it was drawn last.
    void repeat() const;
    /// What a picture shows.
    struct Shot {
        const render::PictureTexture& scene;
        ui::PixelRect area;        ///< of the scene in the window
        const ImDrawData* panels;  ///< null: the scene without them
        ui::PixelRect part;        ///< of the window
        const CaptionStrip* caption = nullptr;
        int caption_height = 0;  ///< below the part
    };
    /// Draws it off-screen: the buffer of the window lacks the parts that other windows cover. Throws GraphicsError.
    Picture read(const Shot& shot) const;

private:
    render::ImguiRenderer panels_;
    render::KeptPicture kept_;
};

}  // namespace steplab
