#include "render/ghosts.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::render {
namespace {

constexpr double spring_thickness = 0.6;  // in that of the leading run's springs
constexpr std::uint8_t spring_alpha = 220, link_alpha = 170;
constexpr double link_width = 1, outline_width = 1.6;  // pixels
constexpr double dash = 4;                             // pixels, as long as the gap behind it
constexpr double most_dashes = 100;                    // of a line; longer ones have longer dashes
constexpr double least_ghost_radius = 1.5;             // pixels
constexpr float filled = 0.26F;                        // opacity within the outline
// Ghosts nearer to their twins, in radii of the particle, are hidden in them.
constexpr double hidden = 0.2;
// Thin springs would only veil those of the leading run, up to a larger difference of their ends.
constexpr double hidden_spring = 0.6;

double radius_of(const KnownShape& known, std::size_t particle) {
    return static_cast<double>(known.part(particle)) * known.largest_radius(known.shape->roles[particle]);
}

double largest_radius(const KnownShape& known) {
    double largest = 0;
    for (const Role role : {Role::moving, Role::fixed, Role::kicked, Role::bullet})
        largest = std::max(largest, known.largest_radius(role));
    return largest;
}

Rgb colour_of(const Shot& shot, std::size_t swatch) { return palette(shot.style.background).runs[swatch]; }

/// Dashes of a line, at even distances in space. Where both ends are seen, they are of about the same length in pixels.
void add_dashes(std::vector<Rod>& rods, const Shot& shot, Vec3 from, Vec3 to, VertexColour colour) {
    if (!drawable(from) || !drawable(to)) return;
    const auto start = shot.projection.pixel(from), end = shot.projection.pixel(to);
    const double length = start && end ? std::hypot(end->x - start->x, end->y - start->y) : INFINITY;
    const double dashes = std::clamp(std::round(length / (2 * dash * shot.style.pixel_scale)), 1.0, most_dashes);
    const glm::vec3 first = vertex(shot.projection, from), way = vertex(shot.projection, to) - first;
    for (double i = 0; i < dashes; ++i) {
        const auto at = [&](double part) { return first + static_cast<float>(part / dashes) * way; };
        rods.push_back({at(i), at(i + 0.5), colour});
    }
}

}  // namespace

std::vector<Vec3> ghost_places(const Frame& leading, const Frame& follower, double magnify) {
    std::vector<Vec3> places(std::min(leading.positions.size(), follower.positions.size()));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vec3 way = leading.shape->nearest(follower.positions[i] - leading.positions[i]);
        places[i] = leading.positions[i] + magnify * way;
    }
    return places;
}

Ghosts::Ghosts() : program_("ghost") {}

void Ghosts::prepare(const Shot& shot, ShownRuns followers, Occupancy& taken) {
    bounds_.reset();
    count_ = std::min(followers.size(), most_shown_runs - 1);
    while (ghosts_.size() < count_) ghosts_.push_back(std::make_unique<Ghost>());
    radius_ = vertex_length(shot.projection, largest_radius(shot.known));
    for (std::size_t i = 0; i < count_; ++i) {
        Ghost& ghost = *ghosts_[i];
        ghost.frame.shape = shot.frame.shape;
        ghost.frame.magnified = shot.frame.magnified;
        ghost.frame.positions = ghost_places(shot.frame, *followers[i].frame, shot.style.magnify);
        ghost.swatch = followers[i].swatch;
        prepare(shot, ghost, taken);
    }
}

void Ghosts::prepare(const Shot& shot, Ghost& ghost, Occupancy& taken) {
    ghost.blocks.place(ghost.frame, shot.projection);
    find_apart(shot, ghost);
    bounds_ = joined(bounds_.value_or(ghost.blocks.bounds()), ghost.blocks.bounds());
    const Shot own{ghost.frame, shot.known, shot.style, shot.scale, shot.projection, shot.tile, shot.part};
    if (shot.style.springs)
        ghost.springs.prepare(
            own, ghost.blocks,
            {spring_thickness, vertex_colour(colour_of(shot, ghost.swatch), spring_alpha), std::span(ghost.bent)});
    link(shot, ghost);
    for (std::size_t i = 0; i < ghost.apart.size(); ++i) {
        if (ghost.apart[i] == 0) ghost.blocks.hide(i);
    }
    const double radius = largest_radius(shot.known);
    ghost.chosen = ghost.blocks.choose(shot.projection, shot.tile, shot.part, radius);
    for (const auto& ranges : ghost.chosen) ghost.blocks.mark(shot.projection, ranges, radius, taken);
    ghost.particles.upload(ghost.blocks.vertices());
    colour(shot, ghost);
}

void Ghosts::find_apart(const Shot& shot, Ghost& ghost) {
    ghost.apart.resize(ghost.frame.positions.size());
    ghost.bent.resize(ghost.frame.positions.size());
    for (std::size_t i = 0; i < ghost.apart.size(); ++i) {
        const double way = length(ghost.frame.drawn(i) - shot.frame.drawn(i));
        ghost.apart[i] = way > hidden * radius_of(shot.known, i);
        ghost.bent[i] = way > hidden_spring * radius_of(shot.known, i);
    }
}

/// A line that would leave the periodic box is drawn half at each end.
void Ghosts::link(const Shot& shot, Ghost& ghost) {
    ghost.links.clear();
    const VertexColour colour = vertex_colour(colour_of(shot, ghost.swatch), link_alpha);
    const auto add = [&](Vec3 from, Vec3 to) { add_dashes(ghost.links, shot, from, to, colour); };
    for (std::size_t i = 0; i < ghost.apart.size(); ++i) {
        const Vec3 way = ghost.frame.drawn(i) - shot.frame.drawn(i);
        if (!(length(way) > radius_of(shot.known, i))) continue;  // hidden in the particle
        const Vec3 from = shot.frame.seen(i), to = ghost.frame.seen(i);
        if (shot.known.shape->seen(from + way) == from + way) {
            add(from, from + way);
        } else {
            add(from, from + 0.5 * way);
            add(to, to - 0.5 * way);
        }
    }
}

/// One colour, with the size of each particle as the shader takes it.
void Ghosts::colour(const Shot& shot, Ghost& ghost) {
    const double largest = largest_radius(shot.known);
    ghost.colours.resize(ghost.apart.size());
    for (std::size_t i = 0; i < ghost.colours.size(); ++i) {
        const double part = radius_of(shot.known, i) / largest;
        ghost.colours[i] =
            vertex_colour(colour_of(shot, ghost.swatch), static_cast<std::uint8_t>(std::lround(255 * part)));
    }
    ghost.particles.colour(ghost.colours);
}

void Ghosts::draw_lines(const ViewUniforms& view, const Style& style) {
    for (std::size_t i = 0; i < count_; ++i) {
        if (style.springs) ghosts_[i]->springs.draw(view, style.pixel_scale);
        lines_.draw(ghosts_[i]->links, view, link_width * style.pixel_scale);
    }
}

void Ghosts::draw_particles(const ViewUniforms& view, double pixel_scale) const {
    for (std::size_t i = 0; i < count_; ++i) {
        view.apply(program_);
        program_.set("u_radius", radius_);
        program_.set("u_least_radius", static_cast<float>(least_ghost_radius * pixel_scale));
        program_.set("u_width", static_cast<float>(outline_width * pixel_scale));
        program_.set("u_filled", filled);
        program_.set("u_outline", static_cast<float>(ghosts_[i]->swatch));
        for (const auto& ranges : ghosts_[i]->chosen) ghosts_[i]->particles.draw_quads(ranges);
    }
}

}  // namespace steplab::render
