#pragma once

#include "render/axes.hpp"
#include "render/instances.hpp"
#include "render/shader_program.hpp"

namespace steplab::render {

/// Draws what is behind and below the scene: the backdrop, the grid on the ground, the lines of the axes.
class Ground {
public:
    Ground();
    /// Fills the target; nothing else needs to be cleared but the depth.
    void draw_backdrop(const Palette& palette, const Tile& tile, const RenderTarget& target) const;
    /// The grid on the lower side of the box; blended, so after everything solid.
    void draw_grid(const AxesBox& box, const ViewUniforms& view, const Palette& palette, double pixel_scale) const;
    void draw_axes(const Axes& axes, const ViewUniforms& view, const Palette& palette, double pixel_scale);

    /// How far the grid reaches from the middle of the box.
    static double reach(const AxesBox& box);

private:
    ShaderProgram backdrop_, ground_, line_;
    VertexArray no_vertices_;  ///< the shaders make their own
    RodList lines_;
};

}  // namespace steplab::render
