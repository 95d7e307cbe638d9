#include "models/scene/mean_nearest.hpp"
#include "models/scene/planner.hpp"
#include "models/scene/scene_particles.hpp"
#include "models/scene/spring_list.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab {

namespace {

/// The mean length of the springs.
double mean_spring(const Shape& shape) {
    double sum = 0;
    for (const Spring& spring : shape.springs)
        sum += length(shape.nearest(shape.rest[spring.second] - shape.rest[spring.first]));
    return shape.springs.empty() ? 0 : sum / static_cast<double>(shape.springs.size());
}

/// The distance of the place that is nearest by this measure; infinite if there is no other.
template <class Measure>
double nearest(const std::vector<Vec3>& places, std::size_t i, const Measure& measure) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t nearest = i;
    for (std::size_t j = 0; j < places.size(); ++j) {
        const double distance = measure(places[j] - places[i]);
        if (distance > 0 && distance < least) least = distance, nearest = j;
    }
    return nearest == i ? std::numeric_limits<double>::infinity() : length(places[nearest] - places[i]);
}

/// Squares are compared, unless they are beyond the range of numbers: a root for each would take longer than to read a
/// million particles.
double distance_of_nearest(const std::vector<Vec3>& places, std::size_t i) {
    const double distance = nearest(places, i, [](Vec3 d) { return dot(d, d); });
    return std::isfinite(distance) ? distance : nearest(places, i, [](Vec3 d) { return length(d); });
}

/// The smallest coordinates and the largest ones.
std::pair<Vec3, Vec3> ends_of(const std::vector<Vec3>& places) {
    Vec3 low = places.front(), high = low;
    for (const Vec3 at : places) {
        low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
    return {low, high};
}

/// Without a corner, the particles are in the middle of the box.
void add_box(const Scene& scene, Shape& shape) {
    shape.box = scene.box.value();
    if (!shape.is_periodic()) return;
    const auto [low, high] = ends_of(shape.rest);
    shape.corner = scene.corner ? scene.corner->value() : low - 0.5 * (shape.box - (high - low));
    const auto expected = [](double side, double corner, double least, double most) {
        return side == 0 ? std::pair(least, most) : std::pair(corner, corner + side);
    };
    const auto x = expected(shape.box.x, shape.corner.x, low.x, high.x);
    const auto y = expected(shape.box.y, shape.corner.y, low.y, high.y);
    const auto z = expected(shape.box.z, shape.corner.z, low.z, high.z);
    shape.expected = {{x.first, y.first, z.first}, {x.second, y.second, z.second}};
}

/// Kept only where they differ.
void add_masses(const SceneParticles& particles, Shape& shape) {
    if (common_mass(particles)) return;
    for (std::size_t i = 0; i < particles.count(); ++i) shape.masses.push_back(particles[i].mass);
}

/// Blocks of one group, or of none, are of one kind.
void add_groups(const Scene& scene, Shape& shape) {
    std::map<std::string_view, std::size_t> names;
    std::vector<std::uint16_t> groups;
    for (const ParticleBlock& block : scene.particles) {
        const std::size_t number = names.try_emplace(block.group, names.size()).first->second;
        groups.insert(groups.end(), block.count(), static_cast<std::uint16_t>(number));
    }
    if (names.size() > 1) shape.groups = std::move(groups);
}

}  // namespace

double mean_nearest(const std::vector<Vec3>& places) {
    constexpr std::size_t most_distances = 300'000'000;  // some tenths of a second
    const std::size_t most = std::clamp<std::size_t>(most_distances / (places.size() + 1), 16, 300);  // asked
    const std::size_t stride = std::max<std::size_t>(1, places.size() / most);
    double sum = 0, asked = 0;
    for (std::size_t i = 0; i < places.size(); i += stride) {
        const double least = distance_of_nearest(places, i);
        if (std::isfinite(least)) sum += least, asked += 1;
    }
    return asked > 0 ? sum / asked : 0;
}

Shape shape_of(const Scene& scene) {
    const SceneParticles particles(scene, SceneParticles::Ask::places);
    const bool roaming = scene.springs.empty() || scene.has_potentials();
    Shape shape;
    for (std::size_t i = 0; i < particles.count(); ++i) {
        const SceneParticle particle = particles[i];
        shape.rest.push_back(roaming ? particle.position + particle.displacement : particle.position);
        shape.roles.push_back(particle.role);
        shape.expected.push_back(particle.position + particle.displacement);
    }
    add_masses(particles, shape);
    add_groups(scene, shape);
    add_box(scene, shape);
    for (const SpringTerm& term : scene.springs) {
        each_spring(particles, term, [&](const ScenePair& pair) {
            const double rest = length(shape.nearest(particles[pair.second].position - particles[pair.first].position));
            shape.springs.push_back({static_cast<std::uint32_t>(pair.first), static_cast<std::uint32_t>(pair.second),
                                     term.length ? term.length->value : rest});
        });
    }
    const double apart = shape.springs.empty() ? mean_nearest(shape.rest) : mean_spring(shape);
    shape.spacing = apart > 0 ? apart : 1;
    return shape;
}

}  // namespace steplab
