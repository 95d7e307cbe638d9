#pragma once

#include "app/offscreen/module.hpp"
#include "render/imgui_renderer.hpp"
#include "render/scene_renderer.hpp"

#include <optional>

namespace steplab {

/// Paints pictures in the current context: the scene and, if requested, the panels of the window over it. Large
/// pictures are painted in tiles, so that only the memory for the picture itself limits their size.
class OffscreenPainter {
public:
    /// Throws UsageError (view), GraphicsError.
    Picture paint(const PictureRequest& request);

private:
    render::SceneRenderer scene_;
    std::optional<render::ImguiRenderer> panels_;  ///< created when first needed
};

}  // namespace steplab
