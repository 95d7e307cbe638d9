#pragma once

#include "render/bounds.hpp"
#include "render/palette.hpp"
#include "render/scene_renderer.hpp"
#include "render/shader_program.hpp"

#include <glm/glm.hpp>

namespace steplab::render {

glm::vec3 in_float(Vec3 v);
/// A point in the coordinates of the shaders: relative to the focus of the camera and in units of its distance, so that
/// float is accurate enough for any position and size of the scene.
glm::vec3 vertex(const Projection& projection, Vec3 point);
/// A length in the same units.
float vertex_length(const Projection& projection, double length);

/// The uniforms of camera and picture that all shaders of the scene share.
class ViewUniforms {
public:
    /// `scene`: the box around everything that is drawn, for the near and far planes; `part`: the size of the tile.
    ViewUniforms(const Projection& projection, const Bounds& scene, const Tile& tile, PictureSize part,
                 const Palette& palette);

    const Projection& projection() const { return projection_; }
    /// Makes the program current and sets the uniforms of shaders/view.glsl and shaders/lighting.glsl.
    void apply(const ShaderProgram& program) const;

private:
    Projection projection_;
    glm::mat4 clip_;
    glm::vec3 backdrop_;
    float sky_, earth_;
};

glm::vec3 as_vec3(Rgb colour);

/// A colour in a vertex.
struct VertexColour {
    std::uint8_t red, green, blue, alpha;
};
constexpr VertexColour vertex_colour(Rgb colour, std::uint8_t alpha = 255) {
    return {colour.red, colour.green, colour.blue, alpha};
}

}  // namespace steplab::render
