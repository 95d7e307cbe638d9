#include "render/springs.hpp"

#include "render/bounds.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::render {
namespace {

constexpr float least_width = 1.15F;  // pixels
/// Lengths in pixels: of the shortest rod that is drawn, and of the shortest at full opacity.
struct LengthsDrawn {
    float least, full;
};
constexpr LengthsDrawn of_few{5, 5.01F};
// In a large scene, short rods would only veil their particles.
constexpr LengthsDrawn of_many{10, 18};
constexpr std::size_t few = 10000;

LengthsDrawn lengths_drawn(std::size_t springs) { return springs <= few ? of_few : of_many; }

constexpr float widest_line = 1.5F;  // pixels: up to this width, rods are drawn as lines of one pixel
constexpr float round_width = 2;     // pixels: the shading of thinner rods is not visible

/// The properties of the view that determine whether and how a rod is drawn.
class RodFilter {
public:
    RodFilter(const Projection& p, float radius, float least_length)
        : eye_(vertex(p, p.eye())),
          right_(in_float(p.right())),
          up_(in_float(p.up())),
          forward_(in_float(p.forward())),
          half_width_(static_cast<float>(p.half_width())),
          half_height_(static_cast<float>(p.half_height())),
          pixels_(static_cast<float>(p.pixels_per_unit(1))),
          margin_(2 * radius),
          least_length_(least_length) {}

    /// True if it is long enough and not entirely beyond one edge of the picture.
    bool worth_drawing(glm::vec3 start, glm::vec3 end) const {
        const glm::vec3 a = start - eye_, b = end - eye_, along = end - start;
        const float depth = std::max(glm::dot(a, forward_), glm::dot(b, forward_));
        const float least = least_length_ * depth / pixels_;
        // The visible length; the rest is along the line of sight.
        const float ahead = glm::dot(along, a);
        const float seen = glm::dot(along, along) - ahead * ahead / glm::dot(a, a);
        return depth > 0 && seen >= least * least && !outside(a, b);
    }
    /// Thickness of a rod of this radius in pixels at its nearest point.
    float thickness(glm::vec3 start, glm::vec3 end, float radius) const {
        const float nearest = std::min(glm::dot(start - eye_, forward_), glm::dot(end - eye_, forward_));
        return nearest > 0 ? 2 * radius * pixels_ / nearest : INFINITY;
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
    float half_width_, half_height_, pixels_, margin_, least_length_;
};

/// The sides of a periodic box in the units of vertices.
glm::vec3 in_vertex_lengths(const Projection& projection, Vec3 box) {
    return {vertex_length(projection, box.x), vertex_length(projection, box.y), vertex_length(projection, box.z)};
}

/// The part of a way that its nearest image does not have: whole sides of the box, or edges of the cell.
glm::vec3 way_through_sides(const Projection& projection, const Frame& frame, glm::vec3 way, glm::vec3 sides) {
    glm::vec3 through(0);
    if (frame.cell) {
        const double unit = projection.camera().distance;
        const Vec3 part = frame.cell->through(unit * Vec3{way.x, way.y, way.z});
        return in_vertex_lengths(projection, part);
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (sides[axis] > 0) through[axis] = sides[axis] * std::round(way[axis] / sides[axis]);
    }
    return through;
}

/// True for a coarse picture all particles of which are but dots: to find out of each spring that it is too short to be
/// drawn would take as long as the rest of the picture.
bool are_between_dots(const Shot& shot, const ParticleBlocks& blocks) {
    if (shot.style.enlarged == 1) return false;
    const double radius = shot.known.largest_radius(Role::moving);
    const auto chosen = blocks.choose(shot.projection, shot.tile, shot.part, radius);
    return chosen[static_cast<std::size_t>(Detail::point)].empty() &&
           chosen[static_cast<std::size_t>(Detail::body)].empty();
}

VertexColour colour_of(const Shot& shot, const Springs::Look& look, std::size_t i) {
    return look.colour ? *look.colour : vertex_colour(spring_colour(shot.frame, shot.style, shot.scale, i));
}

}  // namespace

Springs::Springs() : round_program_("rod"), thin_program_("line") {}

void Springs::prepare(const Shot& shot, const ParticleBlocks& blocks, const Look& look) {
    const auto& [frame, known, style, scale, projection, tile, part] = shot;
    // Colours are visible only on rods that are thick enough.
    const double thickness = look.thickness * (style.colouring == Colouring::strain && !look.colour ? 2 : 1);
    radius_ = vertex_length(projection, thickness * known.sizes.spring_radius());
    const auto [least_length, full_length] = lengths_drawn(known.shape->springs.size());
    least_length_ = least_length;
    full_length_ = full_length;
    const RodFilter filter(projection, radius_, least_length);
    for (Rods* rods : {&round_, &thin_, &thinnest_}) rods->listed.clear();
    const float least = least_width * static_cast<float>(style.pixel_scale);
    const std::span<const Spring> springs =
        are_between_dots(shot, blocks) ? std::span<const Spring>() : known.shape->springs;
    const auto seen = [&](std::size_t i) { return drawable(shot.frame.drawn(i)); };
    const auto add = [&](glm::vec3 start, glm::vec3 end, std::size_t i) {
        if (!filter.worth_drawing(start, end) || !seen(springs[i].first) || !seen(springs[i].second)) return;
        list_for(filter.thickness(start, end, radius_), least).push_back({start, end, colour_of(shot, look, i)});
    };
    const glm::vec3 sides = in_vertex_lengths(projection, known.shape->box);
    for (std::size_t i = 0; i < springs.size(); ++i) {
        if (!look.wants(springs[i])) continue;
        const glm::vec3 start = blocks.vertices()[springs[i].first], end = blocks.vertices()[springs[i].second];
        const glm::vec3 through = way_through_sides(projection, frame, end - start, sides);
        if (through == glm::vec3(0)) {
            add(start, end, i);
        } else {  // to the nearest image: half of it at each end
            add(start, start + 0.5F * (end - start - through), i);
            add(end, end - 0.5F * (end - start - through), i);
        }
    }
    for (Rods* rods : {&round_, &thin_, &thinnest_}) rods->list.upload(std::span<const Rod>(rods->listed));
}

/// The list for a rod of this thickness; `least`: the smallest thickness drawn. Both in pixels.
std::vector<Rod>& Springs::list_for(float thickness, float least) {
    if (thickness > round_width) return round_.listed;
    return thickness > least || least > widest_line ? thin_.listed : thinnest_.listed;
}

void Springs::draw(const ViewUniforms& view, double pixel_scale) const {
    const auto use = [&](const ShaderProgram& program, float breadth) {
        view.apply(program);
        program.set("u_radius", radius_);
        program.set("u_least_width", least_width * static_cast<float>(pixel_scale));
        program.set("u_faded", least_length_);
        program.set("u_fading", full_length_);
        program.set("u_breadth", breadth);
        program.set("u_lit", 1.0F);
    };
    use(round_program_, 1);
    round_.list.draw();
    use(thin_program_, 1);
    thin_.list.draw();
    use(thin_program_, 0);
    thinnest_.list.draw_lines();
}

}  // namespace steplab::render
