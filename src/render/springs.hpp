#pragma once

#include "render/instances.hpp"
#include "render/particle_blocks.hpp"
#include "render/shader_program.hpp"
#include "render/shot.hpp"

#include <vector>

namespace steplab::render {

/// Draws the springs of a frame as thin round rods.
class Springs {
public:
    Springs();
    /// Uploads the springs that the picture shows; those of neighbours only a few pixels apart are left out, as their
    /// particles already cover the picture there.
    void prepare(const Shot& shot, const ParticleBlocks& blocks);
    void draw(const ViewUniforms& view, double pixel_scale) const;

private:
    /// Rods that are drawn alike: round ones; those too thin to show it; and of these the thinnest, drawn as lines.
    struct Rods {
        std::vector<Rod> listed;  ///< kept for its memory
        RodList list;
    };

    std::vector<Rod>& list_for(float thickness, float least);

    ShaderProgram round_program_, thin_program_;
    float radius_ = 0;
    float least_length_ = 0, full_length_ = 1;  ///< pixels: shorter ones are left out, or paler
    Rods round_, thin_, thinnest_;
};

}  // namespace steplab::render
