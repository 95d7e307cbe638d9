#pragma once

#include "render/axes.hpp"
#include "render/lines.hpp"
#include "render/shader_program.hpp"

namespace steplab::render {

/// Draws the backdrop, the grid on the ground and the lines of the axes.
class Ground {
public:
    Ground();
    /// Fills the viewport with a tile of a picture, which has the size `part`; only the depth has to be cleared before.
    void draw_backdrop(const Palette& palette, const Tile& tile, PictureSize part) const;
    /// The grid on the lower side of the box; blended, so to be drawn after everything opaque.
    void draw_grid(const AxesBox& box, const ViewUniforms& view, const Palette& palette, double pixel_scale) const;
    void draw_axes(const Axes& axes, const ViewUniforms& view, const Palette& palette, double pixel_scale);

    /// The square of the grid.
    static Bounds extent(const AxesBox& box);

private:
    /// Half the side of the grid, from the centre of the box.
    static double reach(const AxesBox& box);

    ShaderProgram backdrop_, ground_;
    VertexArray no_vertices_;  ///< the shaders compute them
    Lines lines_;
};

}  // namespace steplab::render
