#pragma once

#include "render/bounds.hpp"
#include "render/palette.hpp"
#include "render/scene_renderer.hpp"
#include "render/shader_program.hpp"

#include <glm/glm.hpp>

#include <vector>

namespace steplab::render {

/// What every shader of the scene is told about the eye and the picture. Floats are relative to the camera's focus.
class ViewUniforms {
public:
    /// `scene` holds everything that is drawn; the near and far planes follow it.
    ViewUniforms(const Projection& projection, const Bounds& scene, const Tile& tile, const RenderTarget& target,
                 const Palette& palette);

    const Projection& projection() const { return projection_; }
    /// A point relative to the focus, in float.
    glm::vec3 relative(Vec3 point) const;
    /// Sets u_rotation, u_eye, u_projection, u_pixels, u_samples, u_sample_count, u_backdrop of the current program.
    void apply(const ShaderProgram& program) const;

private:
    Projection projection_;
    glm::mat4 clip_;
    glm::vec3 backdrop_;
    std::vector<glm::vec2> samples_;
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
