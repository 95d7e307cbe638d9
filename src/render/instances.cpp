#include "render/instances.hpp"

namespace steplab::render {
namespace {

void dot_attributes() {
    float_attribute(0, 3, sizeof(Dot), offsetof(Dot, centre));
    colour_attribute(1, sizeof(Dot), offsetof(Dot, colour));
}

void draw_quad_each(const VertexArray& vertex_array, GLsizei count) {
    if (count == 0) return;
    glBindVertexArray(vertex_array.id());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

}  // namespace

DotList::DotList() {
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    glBindVertexArray(per_vertex_.id());
    dot_attributes();
    glBindVertexArray(per_instance_.id());
    dot_attributes();
    per_instance(0);
    per_instance(1);
}

void DotList::upload(std::span<const Dot> dots) {
    render::upload(buffer_, GL_ARRAY_BUFFER, dots);
    count_ = static_cast<GLsizei>(dots.size());
}

void DotList::draw_points() const {
    if (count_ == 0) return;
    glBindVertexArray(per_vertex_.id());
    draw_bound_points(0, static_cast<std::size_t>(count_));
}

void DotList::draw_quads() const { draw_quad_each(per_instance_, count_); }

RodList::RodList() {
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    glBindVertexArray(vertex_array_.id());
    float_attribute(0, 3, sizeof(Rod), offsetof(Rod, start));
    float_attribute(1, 3, sizeof(Rod), offsetof(Rod, end));
    colour_attribute(2, sizeof(Rod), offsetof(Rod, colour));
    for (const GLuint location : {0U, 1U, 2U}) per_instance(location);
}

void RodList::upload(std::span<const Rod> rods) {
    render::upload(buffer_, GL_ARRAY_BUFFER, rods);
    count_ = static_cast<GLsizei>(rods.size());
}

void RodList::draw() const { draw_quad_each(vertex_array_, count_); }

void RodList::draw_lines() const {
    if (count_ == 0) return;
    glBindVertexArray(vertex_array_.id());
    glDrawArraysInstanced(GL_LINES, 0, 2, count_);
}

}  // namespace steplab::render
