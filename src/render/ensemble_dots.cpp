#include "render/ensemble_dots.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::render {
namespace {

constexpr double part_of_ball = 0.11;  // the radius of a dot
constexpr double least_radius = 0.9;   // pixels

/// The more dots, the fainter: few are seen one by one, many as a density.
std::uint8_t opacity(std::size_t runs) {
    const double opacity = std::clamp(2.8 / std::sqrt(static_cast<double>(runs)), 0.16, 0.55);
    return static_cast<std::uint8_t>(std::lround(255 * opacity));
}

}  // namespace

EnsembleDots::EnsembleDots() : program_("ensemble") {}

void EnsembleDots::prepare(const Shot& shot) {
    listed_.clear();
    bounds_.reset();
    const std::size_t particles = shot.frame.positions.size();
    radius_ = vertex_length(shot.projection, part_of_ball * shot.known.sizes.radius(Role::moving));
    for (std::size_t i = 0; i < shot.frame.ensemble.size(); ++i) {
        const Vec3 place = shot.frame.seen_at(shot.frame.drawn_at(i % particles, shot.frame.ensemble[i]));
        if (!drawable(place)) continue;
        const Rgb colour = particle_colour(shot.frame, shot.style, shot.scale, i % particles);
        listed_.push_back(
            {vertex(shot.projection, place), vertex_colour(colour, opacity(shot.frame.ensemble.size() / particles))});
        bounds_ = joined(bounds_.value_or(Bounds{place, place}), {place, place});
    }
    dots_.upload(std::span<const Dot>(listed_));
}

void EnsembleDots::draw(const ViewUniforms& view, double pixel_scale) const {
    if (listed_.empty()) return;
    view.apply(program_);
    program_.set("u_radius", radius_);
    program_.set("u_least_radius", static_cast<float>(least_radius * pixel_scale));
    dots_.draw_quads();
}

}  // namespace steplab::render
