#include "render/ground.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::render {
namespace {

constexpr float grid_strength = 0.34F;
constexpr float axis_strength = 0.55F;

}  // namespace

Ground::Ground() : backdrop_("backdrop"), ground_("ground") {}

double Ground::reach(const AxesBox& box) {
    const Vec3 size = box.bounds.size();
    return 1.5 * std::max({size.x, size.z, 0.6 * size.y, 4 * box.step});
}

Bounds Ground::extent(const AxesBox& box) {
    const double far = reach(box);
    const Vec3 middle = box.bounds.centre();
    return {{middle.x - far, box.bounds.low.y, middle.z - far}, {middle.x + far, box.bounds.low.y, middle.z + far}};
}

void Ground::draw_backdrop(const Palette& palette, const Tile& tile, PictureSize part) const {
    const double height = tile.whole.height;
    backdrop_.use();
    backdrop_.set("u_rows", glm::vec2(1 - (tile.top + part.height) / height, 1 - tile.top / height));
    backdrop_.set("u_bottom", as_vec3(palette.bottom));
    backdrop_.set("u_top", as_vec3(palette.top));
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Ground::draw_grid(const AxesBox& box, const ViewUniforms& view, const Palette& palette, double pixel_scale) const {
    const Projection& projection = view.projection();
    const Vec3 middle = box.bounds.centre();
    const Vec3 centre{middle.x, box.bounds.low.y, middle.z};
    view.apply(ground_);
    ground_.set("u_centre", vertex(projection, centre));
    ground_.set("u_reach", vertex_length(projection, reach(box)));
    // Relative to the nearest of the stronger lines, so that the numbers in the shader stay small far from the origin.
    const auto to_line = [&](double place) { return vertex_length(projection, std::remainder(-place, 5 * box.step)); };
    ground_.set("u_origin", glm::vec2(to_line(centre.x), to_line(centre.z)));
    ground_.set("u_step", vertex_length(projection, box.step));
    ground_.set("u_width", static_cast<float>(pixel_scale));
    ground_.set("u_colour", as_vec3(palette.grid));
    ground_.set("u_strength", grid_strength);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Ground::draw_axes(const Axes& axes, const ViewUniforms& view, const Palette& palette, double pixel_scale) {
    std::vector<Rod> rods;
    for (const AxisLine& line : axes.lines) {
        const auto alpha = static_cast<std::uint8_t>(std::lround(255 * line.strength * axis_strength));
        rods.push_back({vertex(view.projection(), line.start), vertex(view.projection(), line.end),
                        vertex_colour(palette.grid, alpha)});
    }
    lines_.draw(rods, view, 1.2 * pixel_scale);
}

}  // namespace steplab::render
