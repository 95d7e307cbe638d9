#pragma once

#include "core/frame.hpp"
#include "render/camera.hpp"
#include "render/render_target.hpp"
#include "render/style.hpp"

#include <memory>
#include <optional>

namespace steplab::render {

/// The part of a larger picture that one target holds: pixels from the top left corner of the whole.
struct Tile {
    PictureSize whole;
    int left = 0;
    int top = 0;
};

/// Draws frames: particles, springs, ground grid, axes with their numbers, legend. It belongs to the context that was
/// current when it was made; load_opengl() comes first. Uses nothing of Dear ImGui's current context, so it may work on
/// a thread of its own.
///
///     RenderTarget target({1280, 720});
///     SceneRenderer scene;
///     scene.draw(frame, style, camera, target);
///     ... target.texture(), or target.read()
class SceneRenderer {
public:
    /// Throws GraphicsError: a shader that is missing or does not compile.
    SceneRenderer();
    ~SceneRenderer();
    SceneRenderer(SceneRenderer&&) noexcept;
    SceneRenderer& operator=(SceneRenderer&&) noexcept;

    /// Draws the finished picture into the target's texture. With `tile` the target gets that part of a larger picture.
    void draw(const Frame& frame, const Style& style, const Camera& camera, const RenderTarget& target,
              const std::optional<Tile>& tile = std::nullopt);

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab::render
