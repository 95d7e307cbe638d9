#include "render/particles.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace steplab::render {
namespace {

constexpr float least_ball_radius = 0.75F;  // pixels
// Up to this radius in pixels, cubes and octahedra are drawn as points: their shape is not visible.
constexpr double special_point_radius = 2.5;

constexpr float ring_radius = 1.55F;  // in radii of the particle
constexpr float ring_width = 1.6F;    // pixels
constexpr float least_ring_radius = 6;

std::size_t index(Role role) { return static_cast<std::size_t>(role); }
std::size_t index(Detail detail) { return static_cast<std::size_t>(detail); }

ShaderProgram impostor(const char* fragment_file) {
    return ShaderProgram("impostor.vert", fragment_file, shader_folders());
}

bool outside(PixelPoint centre, double radius, PictureSize size) {
    return centre.x < -radius || centre.y < -radius || centre.x > size.width + radius ||
           centre.y > size.height + radius;
}

/// Sets the uniforms of particles with outlines smoothed by the shader.
void use(const ShaderProgram& program, const ViewUniforms& view, float radius, float least_coverage) {
    view.apply(program);
    program.set("u_radius", radius);
    program.set("u_least_radius", least_ball_radius);
    program.set("u_least_coverage", least_coverage);
}

/// The colour of a particle, with its size as the shaders of balls take it.
VertexColour own_colour(const Shot& shot, std::size_t i) {
    const auto part = static_cast<std::uint8_t>(std::lround(255 * shot.known.part(i)));
    return vertex_colour(particle_colour(shot.frame, shot.style, shot.scale, i), part);
}

/// Of all moving particles; none where they differ.
std::optional<VertexColour> one_colour(const Shot& shot) {
    if (differs_by_particle(shot.frame, shot.style) || !shot.known.parts.empty()) return std::nullopt;
    return vertex_colour(role_colour(shot.style, Role::moving));
}

/// Of the window, for each of the picture.
std::size_t pixels_of(const Style& style) {
    const auto side = static_cast<std::size_t>(style.enlarged);
    return side * side;
}

std::size_t count_of(const std::vector<IndexRange>& ranges) {
    std::size_t count = 0;
    for (const IndexRange& range : ranges) count += range.count;
    return count;
}

/// One of so many dots is drawn, by the style.
std::size_t share_of(const Style& style, std::size_t dots) {
    return style.most_dots == 0 ? 1 : std::max<std::size_t>(1, (dots + style.most_dots - 1) / style.most_dots);
}

}  // namespace

Particles::Particles()
    : sphere_(impostor("sphere.frag")),
      cube_(impostor("cube.frag")),
      octahedron_(impostor("octahedron.frag")),
      point_("point"),
      dot_("dot"),
      ring_("ring") {}

void Particles::prepare(const Shot& shot, ParticleBlocks& blocks, Occupancy& taken) {
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
        kinds_[kind].radius = vertex_length(shot.projection, shot.known.largest_radius(static_cast<Role>(kind)));
    }
    const double radius = shot.known.largest_radius(Role::moving);
    for (const std::uint32_t i : shot.known.special) blocks.hide(i);
    chosen_ = blocks.choose(shot.projection, shot.tile, shot.part, radius);
    const auto& dots = chosen_[index(Detail::dot)];
    one_of_ = share_of(shot.style, count_of(dots));
    const std::size_t one_of = std::max(one_of_, pixels_of(shot.style));
    for (const Detail detail : {Detail::dot, Detail::point, Detail::body})
        blocks.mark(shot.projection, chosen_[index(detail)], radius, taken, detail == Detail::dot ? one_of : 1);
    list_sample(shot, blocks, one_of);
    upload_moving(shot, blocks);
    gather_special(shot, taken);
    prepare_rings(shot);
}

/// In place of all that are dots; they are few, and all others need not be uploaded then.
void Particles::list_sample(const Shot& shot, const ParticleBlocks& blocks, std::size_t one_of) {
    listed_sample_.clear();
    if (one_of > 1) {
        std::vector<IndexRange>& dots = chosen_[index(Detail::dot)];
        const auto colour = one_colour(shot);
        for (const std::uint32_t i : sample_of(dots, one_of))
            listed_sample_.push_back({blocks.vertices()[i], colour ? *colour : own_colour(shot, i)});
        dots.clear();
    }
    sample_.upload(std::span<const Dot>(listed_sample_));
}

void Particles::upload_moving(const Shot& shot, const ParticleBlocks& blocks) {
    const bool wanted = std::any_of(chosen_.begin(), chosen_.end(), [](const auto& ranges) { return !ranges.empty(); });
    if (!wanted) return;
    moving_.upload(blocks.vertices());
    if (const auto colour = one_colour(shot)) return moving_.colour(*colour);
    colours_.resize(shot.frame.positions.size());
    for (const std::vector<IndexRange>& ranges : chosen_) {
        for (const auto& [first, count] : ranges) {
            for (std::size_t i = first; i < first + count; ++i) colours_[i] = own_colour(shot, i);
        }
    }
    moving_.colour(colours_);
}

void Particles::gather_special(const Shot& shot, Occupancy& taken) {
    const Projection& projection = shot.projection;
    for (Kind& kind : kinds_) {
        kind.listed_bodies.clear();
        kind.listed_points.clear();
    }
    for (const std::uint32_t i : shot.known.special) {
        const Vec3 position = shot.frame.seen(i);
        const auto centre = drawable(position) ? projection.pixel(position) : std::nullopt;
        if (!centre) continue;
        const Role role = shot.known.shape->roles[i];
        const double radius = static_cast<double>(shot.known.part(i)) * shot.known.largest_radius(role) *
                              projection.pixels_per_unit(projection.depth(position));
        // Near the edge of the picture, perspective elongates a ball.
        if (outside(*centre, 2 * radius + 1, projection.size())) continue;
        taken.mark(*centre, radius);
        Kind& kind = kinds_[index(role)];
        auto& list = radius > special_point_radius ? kind.listed_bodies : kind.listed_points;
        list.push_back({vertex(projection, position), own_colour(shot, i)});
    }
    for (Kind& kind : kinds_) {
        kind.bodies.upload(std::span<const Dot>(kind.listed_bodies));
        kind.points.upload(std::span<const Dot>(kind.listed_points));
    }
}

void Particles::prepare_rings(const Shot& shot) {
    const auto& [frame, known, style, scale, projection, tile, part] = shot;
    const Palette& colours = palette(style.background);
    std::vector<Dot> kicked;
    for (const std::uint32_t i : known.special) {
        if (known.shape->roles[i] != Role::kicked || !drawable(frame.seen(i))) continue;
        kicked.push_back({vertex(projection, frame.seen(i)), vertex_colour(colours.roles[index(Role::kicked)], 210)});
    }
    kicked_ring_.upload(std::span<const Dot>(kicked));
    std::map<float, std::vector<Dot>> selected;  // by radius
    const auto select = [&, &of = shot](std::size_t i, std::uint8_t opacity) {
        if (i >= of.frame.positions.size() || !drawable(of.frame.seen(i))) return;
        const float radius = of.known.part(i) * kinds_[index(of.known.shape->roles[i])].radius;
        selected[radius].push_back(
            {vertex(of.projection, of.frame.seen(i)), vertex_colour(colours.selection, opacity)});
    };
    for (const std::size_t i : style.selected_too) select(i, 150);
    if (style.selected) select(*style.selected, 235);
    selected_rings_.resize(selected.size());
    auto ring = selected_rings_.begin();
    for (const auto& [radius, dots] : selected) {
        ring->radius = radius;
        (ring++)->dots.upload(std::span<const Dot>(dots));
    }
}

void Particles::draw(const ViewUniforms& view, const RenderTarget& target) const {
    const bool sampled = target.samples() > 1;
    // The alpha of outlines determines the covered samples; the picture itself is opaque.
    const float least_coverage = sampled ? 0.0F : 0.5F;
    const float radius = kinds_[index(Role::moving)].radius;
    glEnable(GL_PROGRAM_POINT_SIZE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    if (sampled) glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    use(sphere_, view, radius, least_coverage);
    moving_.draw_quads(chosen_[index(Detail::body)]);
    const ShaderProgram* programs[] = {&sphere_, &cube_, &sphere_, &octahedron_};
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
        use(*programs[kind], view, kinds_[kind].radius, least_coverage);
        kinds_[kind].bodies.draw_quads();
    }
    for (const Kind& kind : kinds_) {
        use(point_, view, kind.radius, least_coverage);
        kind.points.draw_points();
    }
    use(point_, view, radius, least_coverage);
    moving_.draw_points(chosen_[index(Detail::point)]);
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    use(dot_, view, radius, least_coverage);
    moving_.draw_points(chosen_[index(Detail::dot)]);
    sample_.draw_points();
}

void Particles::draw_rings(const ViewUniforms& view, double pixel_scale) const {
    const auto scale = static_cast<float>(pixel_scale);
    // Rings are visible even behind other particles.
    glDisable(GL_DEPTH_TEST);
    view.apply(ring_);
    ring_.set("u_width", ring_width * scale);
    ring_.set("u_radius", ring_radius * kinds_[index(Role::kicked)].radius);
    ring_.set("u_least_radius", least_ring_radius * scale);
    kicked_ring_.draw_quads();
    // The rings of selected particles are larger than that of the kicked one.
    ring_.set("u_least_radius", 1.3F * least_ring_radius * scale);
    for (const Rings& ring : selected_rings_) {
        ring_.set("u_radius", 1.3F * ring_radius * ring.radius);
        ring.dots.draw_quads();
    }
    glEnable(GL_DEPTH_TEST);
}

}  // namespace steplab::render
