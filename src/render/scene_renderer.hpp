#pragma once

#include "core/frame.hpp"
#include "render/camera.hpp"
#include "render/render_target.hpp"
#include "render/shown_runs.hpp"
#include "render/style.hpp"

#include <memory>
#include <optional>

namespace steplab::render {

/// The part of a larger picture that a target contains, in pixels from the top left corner of the whole.
struct Tile {
    PictureSize whole;
    int left = 0;
    int top = 0;
    friend bool operator==(const Tile&, const Tile&) = default;
};

/// Draws frames: particles, springs, ground grid, axes with numbers, legend. It belongs to the context that was current
/// at its construction, after load_opengl(). It does not use the current context of Dear ImGui and may run on its own
/// thread.
///
///     RenderTarget target({1280, 720});
///     SceneRenderer scene;
///     scene.draw(frame, style, camera, target);
///     ... target.texture(), or target.read()
class SceneRenderer {
public:
    /// Throws GraphicsError if a shader is missing or does not compile.
    SceneRenderer();
    ~SceneRenderer();
    SceneRenderer(SceneRenderer&&) noexcept;
    SceneRenderer& operator=(SceneRenderer&&) noexcept;

    /// Draws a picture into the texture of the target; with `tile`, that part of a larger picture.
    void draw(const Frame& frame, const Style& style, const Camera& camera, const RenderTarget& target,
              const std::optional<Tile>& tile = std::nullopt);
    /// The same with up to most_shown_runs runs, the leading one first, as the style's layout says. In split layout the
    /// camera is that of each tile (split.hpp), and a colour scale holds for all of them.
    void draw(ShownRuns runs, const Style& style, const Camera& camera, const RenderTarget& target,
              const std::optional<Tile>& tile = std::nullopt);

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab::render
