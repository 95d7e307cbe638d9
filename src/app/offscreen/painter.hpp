#pragma once

#include "app/offscreen/module.hpp"
#include "render/imgui_renderer.hpp"
#include "render/scene_renderer.hpp"

#include <optional>

namespace steplab {

/// Paints whole pictures in the context that is current: the scene, and over it the panels of the window if they are
/// asked for. Large pictures are painted in tiles, so that their size is bounded by memory for the picture alone.
class OffscreenPainter {
public:
    /// Throws UsageError (view), GraphicsError.
    Picture paint(const PictureRequest& request);

private:
    render::SceneRenderer scene_;
    std::optional<render::ImguiRenderer> panels_;  ///< made when first asked for
};

}  // namespace steplab
