#pragma once

#include "app/offscreen/module.hpp"
#include "render/imgui_renderer.hpp"
#include "render/render_target.hpp"
#include "render/scene_renderer.hpp"
#include "ui/interface.hpp"

#include <functional>
#include <optional>

namespace steplab {

/// Paints pictures in the current context: the scene and, if requested, the panels of the window over it. Large
/// pictures are painted in tiles, so that only the memory for the picture itself limits their size.
class OffscreenPainter {
public:
    /// The place of a tile in the whole picture.
    struct Place {
        int left;
        int top;
        render::PictureSize size;
    };

    /// Throws UsageError (view), GraphicsError.
    Picture paint(const PictureRequest& request);

private:
    /// What panels are drawn with. Kept from picture to picture: to make the glyphs takes long, and as often as a film
    /// has frames it would leave more and more holes in the memory.
    struct PanelTools {
        explicit PanelTools(const ui::Display& display) : interface(display) {
            renderer.upload_fonts(interface.fonts());
        }

        ui::Interface interface;
        render::ImguiRenderer renderer;
    };

    using PaintTile = std::function<void(const Place&, const render::RenderTarget&)>;

    Picture paint_scene(const PictureRequest& request);
    Picture paint_with_panels(const PictureRequest& request);
    /// Paints all tiles and assembles the picture.
    Picture in_tiles(render::PictureSize size, const PaintTile& paint);

    render::SceneRenderer scene_;
    std::optional<PanelTools> panels_;            ///< made when first needed
    std::optional<render::RenderTarget> target_;  ///< of the last tile
};

}  // namespace steplab
