#pragma once

#include "render/gl_objects.hpp"
#include "render/view_uniforms.hpp"

#include <span>

namespace steplab::render {

/// A particle, or a ring around one, as a vertex of 16 bytes.
struct Dot {
    glm::vec3 centre;  ///< see vertex()
    VertexColour colour;
};

/// A rod between two points as a vertex of 28 bytes.
struct Rod {
    glm::vec3 start;
    glm::vec3 end;
    VertexColour colour;
};

/// A list of dots on the GPU, drawn by the current program as points or as one quad each.
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

/// A list of rods on the GPU.
class RodList {
public:
    RodList();
    void upload(std::span<const Rod> rods);
    /// Draws one quad for each rod.
    void draw() const;
    /// Draws one line for each rod; its vertices have the numbers of the first two of the quad.
    void draw_lines() const;

private:
    GLsizei count_ = 0;
    Buffer buffer_;
    VertexArray vertex_array_;
};

}  // namespace steplab::render
