#pragma once

#include "render/instances.hpp"
#include "render/occupancy.hpp"
#include "render/particle_arrays.hpp"
#include "render/particle_blocks.hpp"
#include "render/shader_program.hpp"
#include "render/shot.hpp"

#include <array>
#include <vector>

namespace steplab::render {

/// Draws the particles of a frame: balls, cubes for fixed ones, an octahedron for the bullet, and rings around the
/// kicked one and the selected ones. Moving particles are drawn in the order of the run, block by block; the few others
/// are collected.
class Particles {
public:
    Particles();

    /// Uploads the particles, chooses those that the picture shows, and marks what they cover in `taken`.
    void prepare(const Shot& shot, ParticleBlocks& blocks, Occupancy& taken);
    /// Draws the particles.
    void draw(const ViewUniforms& view, const RenderTarget& target) const;
    /// One of so many of those that are but dots is drawn, besides what a coarse picture leaves out.
    std::size_t one_of() const { return one_of_; }
    /// Draws the rings; blended, so after everything opaque.
    void draw_rings(const ViewUniforms& view, double pixel_scale) const;

private:
    /// The particles of a role.
    struct Kind {
        float radius = 0;
        DotList bodies, points;
        std::vector<Dot> listed_bodies, listed_points;  ///< kept to reuse their memory
    };

    /// Around selected particles of one radius.
    struct Rings {
        float radius = 0;
        DotList dots;
    };

    void gather_special(const Shot& shot, Occupancy& taken);
    void list_sample(const Shot& shot, const ParticleBlocks& blocks, std::size_t one_of);
    void upload_moving(const Shot& shot, const ParticleBlocks& blocks);
    void prepare_rings(const Shot& shot);

    ShaderProgram sphere_, cube_, octahedron_, point_, dot_, ring_;
    ParticleArrays moving_;
    std::array<std::vector<IndexRange>, details> chosen_;  ///< of the moving ones, by Detail
    std::size_t one_of_ = 1;
    DotList sample_;                     ///< of those that are dots, if not all of them are drawn
    std::vector<Dot> listed_sample_;     ///< kept to reuse its memory
    std::vector<VertexColour> colours_;  ///< kept to reuse its memory
    std::array<Kind, 4> kinds_;          ///< by Role
    DotList kicked_ring_;
    std::vector<Rings> selected_rings_;
};

}  // namespace steplab::render
