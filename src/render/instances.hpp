#pragma once

#include "render/gl_objects.hpp"
#include "render/view_uniforms.hpp"

#include <span>

namespace steplab::render {

/// A particle, or what is drawn around one, as a vertex: 16 bytes.
struct Dot {
    glm::vec3 centre;  ///< see vertex()
    VertexColour colour;
};

/// A rod from one point to another as a vertex: 28 bytes.
struct Rod {
    glm::vec3 start;
    glm::vec3 end;
    VertexColour colour;
};

/// A list of dots on the graphics processor, drawn by the program in use: as points, or as one quad each.
class DotList {
public:
    DotList();
    void upload(std::span<const Dot> dots);
    void draw_points() const;
    void draw_quads() const;

private:
    GLsizei count_ = 0;
    Buffer buffer_;
    VertexArray per_vertex_, per_instance_;
};

/// A list of rods on the graphics processor.
class RodList {
public:
    RodList();
    void upload(std::span<const Rod> rods);
    /// As one quad each.
    void draw() const;
    /// As one line each, whose vertices are numbered as the first two of the quad.
    void draw_lines() const;

private:
    GLsizei count_ = 0;
    Buffer buffer_;
    VertexArray vertex_array_;
};

}  // namespace steplab::render
