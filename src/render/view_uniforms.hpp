#pragma once

#include "render/bounds.hpp"
#include "render/palette.hpp"
#include "render/scene_renderer.hpp"
#include "render/shader_program.hpp"

#include <glm/glm.hpp>

namespace steplab::render {

glm::vec3 in_float(Vec3 v);
/// A point as the shaders get it: relative to the camera's focus and in units of its distance, so that float is enough
/// wherever and however large or small the scene is.
glm::vec3 vertex(const Projection& projection, Vec3 point);
/// A length in the same units.
float vertex_length(const Projection& projection, double length);

/// What every shader of the scene is told about the eye and the picture.
class ViewUniforms {
public:
    /// `scene` holds everything that is drawn; the near and far planes follow it. `part` is the size of the tile.
    ViewUniforms(const Projection& projection, const Bounds& scene, const Tile& tile, PictureSize part,
                 const Palette& palette);

    const Projection& projection() const { return projection_; }
    /// Makes the program the current one and sets what shaders/view.glsl and shaders/lighting.glsl need.
    void apply(const ShaderProgram& program) const;

private:
    Projection projection_;
    glm::mat4 clip_;
    glm::vec3 backdrop_;
    float sky_, earth_;
};

glm::vec3 as_vec3(Rgb colour);

/// A colour as a vertex holds it.
struct VertexColour {
    std::uint8_t red, green, blue, alpha;
};
constexpr VertexColour vertex_colour(Rgb colour, std::uint8_t alpha = 255) {
    return {colour.red, colour.green, colour.blue, alpha};
}

}  // namespace steplab::render
