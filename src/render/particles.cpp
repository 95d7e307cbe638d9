#include "render/particles.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::render {
namespace {

// Up to this radius in pixels a particle is a point: nothing of its shape could be seen.
constexpr double point_radius = 2.5;
constexpr float least_radius = 0.75F;

constexpr float ring_radius = 1.55F;  // in radii of the particle
constexpr float ring_width = 1.6F;    // pixels
constexpr float least_ring_radius = 6;

std::size_t index(Role role) { return static_cast<std::size_t>(role); }

ShaderProgram impostor(const char* fragment_file) {
    return ShaderProgram("impostor.vert", fragment_file, shader_folders());
}

bool outside(PixelPoint centre, double radius, PictureSize size) {
    return centre.x < -radius || centre.y < -radius || centre.x > size.width + radius ||
           centre.y > size.height + radius;
}

}  // namespace

Particles::Particles()
    : sphere_(impostor("sphere.frag")),
      cube_(impostor("cube.frag")),
      octahedron_(impostor("octahedron.frag")),
      point_("point"),
      ring_("ring") {}

void Particles::prepare(const Frame& frame, const Style& style, std::span<const Rgb> colours,
                        const Projection& projection, Occupancy& taken) {
    const DrawnSizes sizes(*frame.shape);
    sort(frame, colours, projection, sizes, taken);
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
        kinds_[kind].radius = vertex_length(projection, sizes.radius(static_cast<Role>(kind)));
        kinds_[kind].bodies.upload(std::span<const Dot>(bodies_[kind]));
        kinds_[kind].points.upload(std::span<const Dot>(points_[kind]));
    }
    prepare_rings(frame, style, projection);
}

void Particles::sort(const Frame& frame, std::span<const Rgb> colours, const Projection& projection,
                     const DrawnSizes& sizes, Occupancy& taken) {
    for (auto* lists : {&bodies_, &points_}) {
        for (auto& list : *lists) list.clear();
    }
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        const Role role = frame.shape->roles[i];
        const auto centre = drawable(frame.positions[i]) ? projection.pixel(frame.positions[i]) : std::nullopt;
        if (!centre) continue;
        const double scale = projection.pixels_per_unit(projection.depth(frame.positions[i]));
        const double radius = scale * sizes.radius(role);
        // The picture of a ball near the edge is longer than its radius.
        if (outside(*centre, 2 * radius + 1, projection.size())) continue;
        taken.mark(*centre, radius);
        auto& lists = radius > point_radius ? bodies_ : points_;
        lists[index(role)].push_back({vertex(projection, frame.positions[i]), vertex_colour(colours[i])});
    }
}

void Particles::prepare_rings(const Frame& frame, const Style& style, const Projection& projection) {
    const Palette& colours = palette(style.background);
    std::vector<Dot> kicked;
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        if (frame.shape->roles[i] != Role::kicked || !drawable(frame.positions[i])) continue;
        kicked.push_back(
            {vertex(projection, frame.positions[i]), vertex_colour(colours.roles[index(Role::kicked)], 210)});
    }
    kicked_ring_.upload(std::span<const Dot>(kicked));
    std::vector<Dot> selected;
    if (style.selected && *style.selected < frame.positions.size() && drawable(frame.positions[*style.selected])) {
        const std::size_t i = *style.selected;
        selected.push_back({vertex(projection, frame.positions[i]), vertex_colour(colours.selection, 235)});
        selected_radius_ = kinds_[index(frame.shape->roles[i])].radius;
    }
    selected_ring_.upload(std::span<const Dot>(selected));
}

void Particles::draw(const ViewUniforms& view, const RenderTarget& target) const {
    const ShaderProgram* programs[] = {&sphere_, &cube_, &sphere_, &octahedron_};
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
        view.apply(*programs[kind]);
        programs[kind]->set("u_radius", kinds_[kind].radius);
        kinds_[kind].bodies.draw_quads();
    }
    glEnable(GL_PROGRAM_POINT_SIZE);
    view.apply(point_);
    point_.set("u_resolution", static_cast<float>(target.supersampling()));
    point_.set("u_least_radius", least_radius);
    for (const Kind& kind : kinds_) {
        point_.set("u_radius", kind.radius);
        kind.points.draw_points();
    }
}

void Particles::draw_rings(const ViewUniforms& view, double pixel_scale) const {
    const auto scale = static_cast<float>(pixel_scale);
    // What is marked is found again even behind others.
    glDisable(GL_DEPTH_TEST);
    view.apply(ring_);
    ring_.set("u_width", ring_width * scale);
    ring_.set("u_radius", ring_radius * kinds_[index(Role::kicked)].radius);
    ring_.set("u_least_radius", least_ring_radius * scale);
    kicked_ring_.draw_quads();
    // The ring of the selected particle stands clear of the kicked one's.
    ring_.set("u_radius", 1.3F * ring_radius * selected_radius_);
    ring_.set("u_least_radius", 1.3F * least_ring_radius * scale);
    selected_ring_.draw_quads();
    glEnable(GL_DEPTH_TEST);
}

}  // namespace steplab::render
