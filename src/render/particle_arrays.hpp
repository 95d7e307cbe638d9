#pragma once

#include "render/gl_objects.hpp"
#include "render/particle_blocks.hpp"
#include "render/view_uniforms.hpp"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace steplab::render {

/// One of `one_of` particles, at uneven distances: even ones would make stripes of a grid. In every picture the same.
std::vector<std::uint32_t> sample_of(std::span<const IndexRange> ranges, std::size_t one_of);

/// Particles on the GPU, in the order of the run. Ranges of them are drawn by the current program as points or as one
/// quad each. Attribute 0 is the centre, attribute 1 the colour.
class ParticleArrays {
public:
    ParticleArrays();

    void upload(std::span<const glm::vec3> centres);
    /// Sets one colour for each particle.
    void colour(std::span<const VertexColour> colours);
    /// Sets one colour for all particles.
    void colour(VertexColour colour);

    void draw_points(std::span<const IndexRange> ranges) const;
    void draw_quads(std::span<const IndexRange> ranges) const;

private:
    void bind(const VertexArray& vertex_array, std::size_t first) const;

    Buffer centres_, colours_;
    VertexArray points_, quads_;
    bool one_colour_ = true;
    VertexColour colour_{};
};

}  // namespace steplab::render
