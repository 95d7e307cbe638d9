#pragma once

#include "render/instances.hpp"
#include "render/particle_blocks.hpp"
#include "render/shader_program.hpp"
#include "render/shot.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace steplab::render {

/// Draws the springs of a frame as thin round rods.
class Springs {
public:
    Springs();
    /// Another look than that of the style.
    struct Look {
        double thickness = 1;                ///< in that of usual springs
        std::optional<VertexColour> colour;  ///< none: by the style
        /// One per particle: springs between two that are 0 are left out. Empty: none is.
        std::span<const std::uint8_t> wanted;

        bool wants(const Spring& spring) const {
            return wanted.empty() || wanted[spring.first] != 0 || wanted[spring.second] != 0;
        }
    };
    /// Uploads the springs that the picture shows. Springs of only a few pixels are left out, as their particles
    /// already cover them.
    void prepare(const Shot& shot, const ParticleBlocks& blocks, const Look& look);
    void prepare(const Shot& shot, const ParticleBlocks& blocks) { prepare(shot, blocks, Look{}); }
    void draw(const ViewUniforms& view, double pixel_scale) const;

private:
    /// Rods of one kind: round ones, thin ones without visible shading, and the thinnest, drawn as lines.
    struct Rods {
        std::vector<Rod> listed;  ///< kept to reuse its memory
        RodList list;
    };

    std::vector<Rod>& list_for(float thickness, float least);

    ShaderProgram round_program_, thin_program_;
    float radius_ = 0;
    float least_length_ = 0, full_length_ = 1;  ///< pixels: shorter springs are left out, or fainter
    Rods round_, thin_, thinnest_;
};

}  // namespace steplab::render
