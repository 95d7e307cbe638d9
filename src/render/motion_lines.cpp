#include "render/motion_lines.hpp"

#include "core/ticks.hpp"
#include "render/bounds.hpp"
#include "render/palette.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::render {
namespace {

constexpr std::size_t most_arrows = 20000;
constexpr double longest_arrow = 1.2;  // in distances of neighbours
constexpr double head_length = 0.22, head_width = 0.09, largest_head = 0.25;

/// The largest length that is a number, rounded up so that it rarely changes while a scene moves.
double scale_of(const std::vector<Vec3>& vectors) {
    double largest = 0;
    for (const Vec3& vector : vectors) {
        const double size = length(vector);
        if (std::isfinite(size)) largest = std::max(largest, size);
    }
    return nice_ceil(largest);
}

/// A line with two more at its end, which face the camera.
void add_arrow(std::vector<Rod>& lines, const Projection& projection, Vec3 from, Vec3 way, double spacing,
               VertexColour colour) {
    const Vec3 to = from + way;
    const double reach = length(way), head = std::min(reach, largest_head * spacing / head_length);
    const Vec3 along = (1 / reach) * way, side = cross(along, projection.forward());
    lines.push_back({vertex(projection, from), vertex(projection, to), colour});
    const double across = length(side);
    if (across < 1e-6) return;  // seen from its end
    for (const double sign : {-1.0, 1.0}) {
        const Vec3 barb = to - head_length * head * along + (sign * head_width * head / across) * side;
        lines.push_back({vertex(projection, to), vertex(projection, barb), colour});
    }
}

/// One for each particle.
void add_arrows(std::vector<Rod>& lines, const Shot& shot, const std::vector<Vec3>& vectors, VertexColour colour) {
    const double largest = scale_of(vectors), spacing = shot.known.shape->spacing;
    if (!(largest > 0)) return;
    const std::size_t count = vectors.size(), stride = 1 + count / most_arrows;
    for (std::size_t i = 0; i < count; i += stride) {
        const Vec3 way = (longest_arrow * spacing / largest) * vectors[i], from = shot.frame.seen(i);
        // shorter ones are hidden in their particles
        if (!drawable(from) || !(length(way) > 0.02 * spacing) || !drawable(from + way)) continue;
        add_arrow(lines, shot.projection, from, way, spacing, colour);
    }
}

void add_trail(std::vector<Rod>& lines, const Shot& shot, const std::vector<Vec3>& places) {
    const Frame& frame = shot.frame;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const Vec3 from = frame.seen_at(places[i - 1]), to = frame.seen_at(places[i]);
        if (!drawable(from) || !drawable(to) || frame.nearest(to - from) != to - from) continue;
        const double age = static_cast<double>(places.size() - i) / static_cast<double>(places.size());
        const auto alpha = static_cast<std::uint8_t>(std::lround(255 * (1 - 0.9 * age)));
        lines.push_back({vertex(shot.projection, from), vertex(shot.projection, to),
                         vertex_colour(palette(shot.style.background).selection, alpha)});
    }
}

}  // namespace

std::vector<Rod> motion_arrows(const Shot& shot) {
    std::vector<Rod> lines;
    const Palette& colours = palette(shot.style.background);
    if (shot.style.velocities) add_arrows(lines, shot, shot.frame.velocities, vertex_colour(colours.text, 230));
    if (shot.style.forces) add_arrows(lines, shot, shot.frame.forces, vertex_colour(colours.force, 230));
    if (shot.style.oscillation && shot.frame.oscillation.size() == shot.frame.positions.size())
        add_arrows(lines, shot, shot.frame.oscillation, vertex_colour(colours.selection, 255));
    return lines;
}

std::vector<Rod> trail_lines(const Shot& shot) {
    std::vector<Rod> lines;
    if (!shot.style.trails) return lines;
    for (const std::vector<Vec3>& places : *shot.style.trails) add_trail(lines, shot, places);
    return lines;
}

}  // namespace steplab::render
