#pragma once

#include "core/frame.hpp"
#include "render/colouring.hpp"
#include "render/drawn_sizes.hpp"
#include "render/instances.hpp"
#include "render/occupancy.hpp"
#include "render/shader_program.hpp"

#include <array>

namespace steplab::render {

/// Draws the particles of a frame: balls; cubes where they are fixed; an octahedron for the bullet; a ring around the
/// kicked and around the selected one. Particles of one kind are one draw; those of few pixels are drawn as points.
class Particles {
public:
    Particles();

    /// Sorts the particles that the picture shows by kind and size and uploads them. Marks where they are in `taken`.
    void prepare(const Frame& frame, const Style& style, std::span<const Rgb> colours, const Projection& projection,
                 Occupancy& taken);
    /// Draws the bodies.
    void draw(const ViewUniforms& view, const RenderTarget& target) const;
    /// Draws the rings; they are blended, so after everything solid.
    void draw_rings(const ViewUniforms& view, double pixel_scale) const;

private:
    /// One kind of particle: all of a role.
    struct Kind {
        float radius = 0;
        DotList bodies, points;
    };

    void sort(const Frame& frame, std::span<const Rgb> colours, const Projection& projection, const DrawnSizes& sizes,
              Occupancy& taken);
    void prepare_rings(const Frame& frame, const Style& style, const Projection& projection);

    ShaderProgram sphere_, cube_, octahedron_, point_, ring_;
    std::array<Kind, 4> kinds_;                        ///< by Role
    std::array<std::vector<Dot>, 4> bodies_, points_;  ///< kept for their memory
    DotList kicked_ring_, selected_ring_;
    float selected_radius_ = 0;
};

}  // namespace steplab::render
