#include "render/springs.hpp"

#include "render/bounds.hpp"
#include "render/drawn_sizes.hpp"

#include <algorithm>

namespace steplab::render {
namespace {

constexpr float least_width = 1.15F;  // pixels
constexpr double least_length = 5;    // pixels

/// True if both ends lie beyond the same edge of the picture.
bool outside(PixelPoint a, PixelPoint b, PictureSize size) {
    return std::max(a.x, b.x) < 0 || std::max(a.y, b.y) < 0 || std::min(a.x, b.x) > size.width ||
           std::min(a.y, b.y) > size.height;
}

bool worth_drawing(Vec3 start, Vec3 end, const Projection& projection) {
    if (!drawable(start) || !drawable(end)) return false;
    const double depth = std::max(projection.depth(start), projection.depth(end));
    if (depth <= 0 || length(end - start) * projection.pixels_per_unit(depth) < least_length) return false;
    const auto a = projection.pixel(start);
    const auto b = projection.pixel(end);
    return !a || !b || !outside(*a, *b, projection.size());
}

}  // namespace

Springs::Springs() : program_("rod") {}

void Springs::prepare(const Frame& frame, const Style& style, std::span<const Rgb> colours,
                      const Projection& projection) {
    rods_.clear();
    // Colours are seen only on what is thick enough.
    const double thickness = style.colouring == Colouring::strain ? 2 : 1;
    radius_ = vertex_length(projection, thickness * DrawnSizes(*frame.shape).spring_radius());
    for (std::size_t i = 0; i < frame.shape->springs.size(); ++i) {
        const Spring& spring = frame.shape->springs[i];
        const Vec3 start = frame.positions[spring.first];
        const Vec3 end = frame.positions[spring.second];
        if (!worth_drawing(start, end, projection)) continue;
        rods_.push_back({vertex(projection, start), vertex(projection, end), vertex_colour(colours[i])});
    }
    list_.upload(std::span<const Rod>(rods_));
}

void Springs::draw(const ViewUniforms& view, double pixel_scale) const {
    view.apply(program_);
    program_.set("u_radius", radius_);
    program_.set("u_least_width", least_width * static_cast<float>(pixel_scale));
    program_.set("u_lit", 1.0F);
    list_.draw();
}

}  // namespace steplab::render
