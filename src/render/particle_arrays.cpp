#include "render/particle_arrays.hpp"

#include <algorithm>
#include <random>
#include <vector>

namespace steplab::render {
namespace {

/// Adds one of `one_of` numbers from `begin` to `end`.
void pick(std::vector<std::uint32_t>& picked, std::size_t begin, std::size_t end, std::size_t one_of) {
    std::minstd_rand random(static_cast<std::minstd_rand::result_type>(begin + 1));
    for (std::size_t i = begin + random() % one_of; i < end; i += 1 + random() % (2 * one_of - 1))
        picked.push_back(static_cast<std::uint32_t>(i));
}

}  // namespace

std::vector<std::uint32_t> sample_of(std::span<const IndexRange> ranges, std::size_t one_of) {
    std::vector<std::uint32_t> some;
    for (const auto& [first, count] : ranges) {
        // Blocks begin at the same places in every picture, so that the same particles are drawn.
        for (std::size_t block = first; block < first + count; block += ParticleBlocks::block_size)
            pick(some, block, std::min(block + ParticleBlocks::block_size, first + count), one_of);
    }
    return some;
}

ParticleArrays::ParticleArrays() {
    glBindVertexArray(quads_.id());
    for (const GLuint location : {0U, 1U}) per_instance(location);
}

void ParticleArrays::upload(std::span<const glm::vec3> centres) { render::upload(centres_, GL_ARRAY_BUFFER, centres); }

void ParticleArrays::colour(std::span<const VertexColour> colours) {
    render::upload(colours_, GL_ARRAY_BUFFER, colours);
    one_colour_ = false;
}

void ParticleArrays::colour(VertexColour colour) {
    colour_ = colour;
    one_colour_ = true;
}

/// Attributes that begin with the particle `first`.
void ParticleArrays::bind(const VertexArray& vertex_array, std::size_t first) const {
    glBindVertexArray(vertex_array.id());
    glBindBuffer(GL_ARRAY_BUFFER, centres_.id());
    float_attribute(0, 3, sizeof(glm::vec3), first * sizeof(glm::vec3));
    if (one_colour_) {
        glDisableVertexAttribArray(1);
        glVertexAttrib4Nub(1, colour_.red, colour_.green, colour_.blue, colour_.alpha);
    } else {
        glBindBuffer(GL_ARRAY_BUFFER, colours_.id());
        colour_attribute(1, sizeof(VertexColour), first * sizeof(VertexColour));
    }
}

void ParticleArrays::draw_points(std::span<const IndexRange> ranges) const {
    if (ranges.empty()) return;
    bind(points_, 0);
    for (const auto& [first, count] : ranges) draw_bound_points(first, count);
}

void ParticleArrays::draw_quads(std::span<const IndexRange> ranges) const {
    // OpenGL 3.3 has no first instance: the attributes start at an offset instead.
    for (const IndexRange& range : ranges) {
        bind(quads_, range.first);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(range.count));
    }
}

}  // namespace steplab::render
