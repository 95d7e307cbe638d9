#pragma once

#include "render/gl_objects.hpp"
#include "render/imgui_renderer.hpp"
#include "render/panel_changes.hpp"
#include "render/picture_texture.hpp"
#include "render/split.hpp"

#include <optional>
#include <span>

struct ImDrawData;

namespace steplab::render {

/// The picture of a scene with the panels over it, in which only what has changed is drawn again.
class KeptPicture {
public:
    /// To be called when a texture of the panels has other content.
    void forget_panels() { changes_.forget(); }
    /// To be called when the scene has another picture.
    void forget_scene() { scene_area_.reset(); }
    /// Draws it, of the size of the panels, unless it looks as it did. The scene is stretched to its area where its
    /// picture has another size, and missing while that is 0 x 0. Returns the number of pixels that were drawn.
    int draw(const PictureTexture& scene, const PictureArea& area, const ImDrawData& panels,
             const ImguiRenderer& renderer);
    /// Copies the scene into the framebuffer of this name, `height` pixels high, as far as it lies in one of the parts.
    void copy_scene(const PictureTexture& scene, const PictureArea& area, GLuint to, int height,
                    std::span<const PictureArea> parts) const;

    PictureSize size() const { return kept_.size(); }
    GLuint framebuffer() const { return framebuffer_.id(); }

private:
    void resize(PictureSize size);

    Framebuffer scene_;
    PanelChanges changes_;
    PictureTexture kept_;
    Framebuffer framebuffer_;
    std::optional<PictureArea> scene_area_;  ///< of the scene as it was drawn last
};

}  // namespace steplab::render
