#include "render/view_uniforms.hpp"

#include <algorithm>

namespace steplab::render {
namespace {

// With a nearer near plane, relative to the farthest depth, a 24-bit depth buffer would not separate surfaces.
constexpr double least_near = 1e-4;

/// In units of the camera's distance.
struct DepthRange {
    double nearest;
    double farthest;
};

DepthRange depth_range(const Projection& projection, const Bounds& scene) {
    double nearest = projection.depth(scene.low);
    double farthest = nearest;
    for (const Vec3& corner : scene.corners()) {
        nearest = std::min(nearest, projection.depth(corner));
        farthest = std::max(farthest, projection.depth(corner));
    }
    farthest = std::max(farthest, projection.camera().distance);
    const double distance = projection.camera().distance;
    return {std::clamp(nearest, least_near * farthest, 0.5 * distance) / distance, 1.01 * farthest / distance};
}

/// From camera space (along -z) to the part of the picture in the tile.
glm::mat4 clip_matrix(const Projection& projection, DepthRange range, const Tile& tile, PictureSize part) {
    const double left = 2.0 * tile.left / tile.whole.width - 1;
    const double right = 2.0 * (tile.left + part.width) / tile.whole.width - 1;
    const double top = 1 - 2.0 * tile.top / tile.whole.height;
    const double bottom = 1 - 2.0 * (tile.top + part.height) / tile.whole.height;
    const double sx = 2 / (right - left);
    const double sy = 2 / (top - bottom);
    glm::dmat4 clip(0);
    clip[0][0] = sx / projection.half_width();
    clip[1][1] = sy / projection.half_height();
    clip[2][0] = sx * (left + right) / 2;  // multiplied by z, which is -w
    clip[2][1] = sy * (top + bottom) / 2;
    clip[2][2] = -(range.farthest + range.nearest) / (range.farthest - range.nearest);
    clip[2][3] = -1;
    clip[3][2] = -2 * range.farthest * range.nearest / (range.farthest - range.nearest);
    return glm::mat4(clip);
}

}  // namespace

glm::vec3 in_float(Vec3 v) { return glm::vec3(glm::dvec3(v.x, v.y, v.z)); }

glm::vec3 as_vec3(Rgb colour) { return glm::vec3(colour.red, colour.green, colour.blue) / 255.0f; }

ViewUniforms::ViewUniforms(const Projection& projection, const Bounds& scene, const Tile& tile, PictureSize part,
                           const Palette& palette)
    : projection_(projection),
      clip_(clip_matrix(projection, depth_range(projection, scene), tile, part)),
      backdrop_(0.5f * (as_vec3(palette.top) + as_vec3(palette.bottom))),
      sky_(static_cast<float>(palette.sky)),
      earth_(static_cast<float>(palette.earth)) {}

glm::vec3 vertex(const Projection& projection, Vec3 point) {
    const Camera& camera = projection.camera();
    return in_float((1 / camera.distance) * (point - camera.focus));
}

float vertex_length(const Projection& projection, double length) {
    return static_cast<float>(length / projection.camera().distance);
}

void ViewUniforms::apply(const ShaderProgram& program) const {
    const Projection& p = projection_;
    program.use();
    program.set("u_rotation",
                glm::transpose(glm::mat3(in_float(p.right()), in_float(p.up()), in_float(-1.0 * p.forward()))));
    program.set("u_eye", vertex(p, p.eye()));
    program.set("u_clip", clip_);
    program.set("u_pixels", static_cast<float>(p.pixels_per_unit(1)));
    program.set("u_backdrop", backdrop_);
    program.set("u_sky", sky_);
    program.set("u_earth", earth_);
}

}  // namespace steplab::render
