#include "render/springs.hpp"

#include "render/bounds.hpp"

#include <algorithm>

namespace steplab::render {
namespace {

constexpr float least_width = 1.15F;   // pixels
constexpr float least_length = 5;      // pixels

constexpr float round_width = 2;       // pixels: thinner ones do not show that they are round

/// What of the view decides whether a rod is drawn, and how.
class RodFilter {
public:
    RodFilter(const Projection& p, float radius)
        : eye_(vertex(p, p.eye())),
          right_(in_float(p.right())),
          up_(in_float(p.up())),
          forward_(in_float(p.forward())),
          half_width_(static_cast<float>(p.half_width())),
          half_height_(static_cast<float>(p.half_height())),
          pixels_(static_cast<float>(p.pixels_per_unit(1))),
          margin_(2 * radius) {}

    /// True if it is long enough and not all of it lies beyond one edge of the picture.
    bool worth_drawing(glm::vec3 start, glm::vec3 end) const {
        const glm::vec3 a = start - eye_, b = end - eye_, along = end - start;
        const float depth = std::max(glm::dot(a, forward_), glm::dot(b, forward_));
        const float least = least_length * depth / pixels_;
        return depth > 0 && glm::dot(along, along) >= least * least && !outside(a, b);
    }
    bool is_round(glm::vec3 start, glm::vec3 end, float radius) const {
        const float nearest = std::min(glm::dot(start - eye_, forward_), glm::dot(end - eye_, forward_));
        return 2 * radius * pixels_ > round_width * nearest;
    }

private:
    bool outside(glm::vec3 a, glm::vec3 b) const {
        const float ax = glm::dot(a, right_), ay = glm::dot(a, up_), bx = glm::dot(b, right_), by = glm::dot(b, up_);
        const float a_depth = glm::dot(a, forward_), b_depth = glm::dot(b, forward_);
        const float a_width = half_width_ * a_depth + margin_, b_width = half_width_ * b_depth + margin_;
        const float a_height = half_height_ * a_depth + margin_, b_height = half_height_ * b_depth + margin_;
        return (ax > a_width && bx > b_width) || (-ax > a_width && -bx > b_width) || (ay > a_height && by > b_height) ||
               (-ay > a_height && -by > b_height);
    }

    glm::vec3 eye_, right_, up_, forward_;
    float half_width_, half_height_, pixels_, margin_;
};

}  // namespace

Springs::Springs() : round_program_("rod"), thin_program_("line") {}

void Springs::prepare(const Shot& shot, const ParticleBlocks& blocks) {
    const auto& [frame, known, style, scale, projection, tile, part] = shot;
    // Colours are seen only on what is thick enough.
    const double thickness = style.colouring == Colouring::strain ? 2 : 1;
    radius_ = vertex_length(projection, thickness * known.sizes.spring_radius());
    const RodFilter filter(projection, radius_);
    round_.listed.clear();
    thin_.listed.clear();
    const std::span<const Spring> springs = known.shape->springs;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const glm::vec3 start = blocks.vertices()[springs[i].first], end = blocks.vertices()[springs[i].second];
        if (!filter.worth_drawing(start, end)) continue;
        if (!drawable(frame.positions[springs[i].first]) || !drawable(frame.positions[springs[i].second])) continue;
        auto& list = filter.is_round(start, end, radius_) ? round_.listed : thin_.listed;
        list.push_back({start, end, vertex_colour(spring_colour(frame, style, scale, i))});
    }
    for (Rods* rods : {&round_, &thin_}) rods->list.upload(std::span<const Rod>(rods->listed));
}

void Springs::draw(const ViewUniforms& view, double pixel_scale) const {
    const auto draw = [&](const ShaderProgram& program, const Rods& rods) {
        view.apply(program);
        program.set("u_radius", radius_);
        program.set("u_least_width", least_width * static_cast<float>(pixel_scale));
        program.set("u_lit", 1.0F);
        rods.list.draw();
    };
    draw(round_program_, round_);
    draw(thin_program_, thin_);
}

}  // namespace steplab::render
