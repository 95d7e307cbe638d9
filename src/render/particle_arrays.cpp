#include "render/particle_arrays.hpp"

#include <vector>

namespace steplab::render {

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
    std::vector<GLint> firsts;
    std::vector<GLsizei> counts;
    for (const IndexRange& range : ranges) {
        firsts.push_back(static_cast<GLint>(range.first));
        counts.push_back(static_cast<GLsizei>(range.count));
    }
    bind(points_, 0);
    glMultiDrawArrays(GL_POINTS, firsts.data(), counts.data(), static_cast<GLsizei>(ranges.size()));
}

void ParticleArrays::draw_quads(std::span<const IndexRange> ranges) const {
    // OpenGL 3.3 has no first instance: the attributes start at an offset instead.
    for (const IndexRange& range : ranges) {
        bind(quads_, range.first);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(range.count));
    }
}

}  // namespace steplab::render
