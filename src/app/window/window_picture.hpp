#pragma once

#include "app/offscreen/module.hpp"
#include "app/window/caption_strip.hpp"
#include "render/gl_objects.hpp"
#include "render/imgui_renderer.hpp"
#include "render/panel_changes.hpp"
#include "render/picture_texture.hpp"
#include "ui/display.hpp"

struct ImDrawData;
struct ImFontAtlas;

namespace steplab {

/// What the window shows: the picture of the scene and the panels over it. Of the panels it keeps a picture, in which
/// only what has changed is drawn again.
class WindowPicture {
public:
    /// To be called when the fonts of the interface were built again.
    void upload_fonts(ImFontAtlas& fonts);
    /// To be called when another texture of the panels has other content.
    void forget_panels() { changes_.forget(); }
    /// To be called when the scene has another picture.
    void forget_scene() { scene_area_.reset(); }
    /// Draws it in the window unless it looks as it did: false, then. The scene is stretched to its area where its
    /// picture has another size.
    bool draw(const render::PictureTexture& scene, const ui::PixelRect& area, const ImDrawData& panels);
    /// Draws it as it was drawn last.
    void repeat() const { show(kept_.size()); }
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
    void show(render::PictureSize size) const;
    /// Copies the scene into the framebuffer of this name.
    void copy_scene(const render::PictureTexture& scene, const ui::PixelRect& area, int height, GLuint to) const;

    render::ImguiRenderer panels_;
    render::Framebuffer scene_;
    render::PanelChanges changes_;
    render::PictureTexture kept_;
    render::Framebuffer kept_framebuffer_;
    std::optional<ui::PixelRect> scene_area_;  ///< of the scene as it was drawn last
};

}  // namespace steplab
