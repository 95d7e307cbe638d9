#pragma once

#include "render/bounds.hpp"
#include "render/gl_objects.hpp"
#include "render/picture_texture.hpp"
#include "render/render_target.hpp"
#include "render/scene_renderer.hpp"
#include "render/shader_program.hpp"
#include "render/shown_runs.hpp"
#include "render/split.hpp"

#include <array>
#include <optional>

namespace steplab::render {

/// The backdrop and the grid below the scene of each run. Neither changes while the camera rests, nor has it edges that
/// several samples of a pixel would show: it is drawn into the picture itself, once, and copied from then on.
class Underlay {
public:
    /// All that it depends on.
    struct Look {
        Camera camera;
        Tile tile;         ///< of the run's own picture
        PictureArea port;  ///< where that tile is in the target
        Background background = Background::dark;
        std::optional<AxesBox> box;  ///< of the grid; none: the backdrop alone
        double pixel_scale = 1;
        friend bool operator==(const Look&, const Look&) = default;
    };

    Underlay();
    /// Copies it into the picture of the target, which is bound; false if it has to be drawn there.
    bool repeat(std::size_t run, const Look& look, const RenderTarget& target);
    /// It was drawn into the picture of the target, which is bound. Where it looks as before, it is kept from now on.
    void keep(std::size_t run, const Look& look, const RenderTarget& target);
    /// Draws what the picture of the target shows into all samples of the bound framebuffer.
    void draw_into_samples(const RenderTarget& target) const;

private:
    void forget_below(const PictureArea& port);

    ShaderProgram program_;
    VertexArray no_vertices_;  ///< the shaders compute them
    PictureTexture picture_;
    Framebuffer framebuffer_;
    std::array<std::optional<Look>, most_shown_runs> kept_, drawn_;  ///< by run
};

}  // namespace steplab::render
