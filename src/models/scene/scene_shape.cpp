#include "models/scene/planner.hpp"
#include "models/scene/scene_particles.hpp"
#include "models/scene/spring_list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace steplab {

namespace {

/// The mean length of the springs; without any, the mean distance of a particle from the nearest one.
double mean_spring(const Shape& shape) {
    double sum = 0;
    for (const Spring& spring : shape.springs) sum += length(shape.rest[spring.second] - shape.rest[spring.first]);
    return shape.springs.empty() ? 0 : sum / static_cast<double>(shape.springs.size());
}

double mean_nearest(const std::vector<Vec3>& places) {
    constexpr std::size_t most = 300;  // asked
    const std::size_t stride = std::max<std::size_t>(1, places.size() / most);
    double sum = 0, asked = 0;
    for (std::size_t i = 0; i < places.size(); i += stride) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < places.size(); ++j) {
            const double distance = length(places[j] - places[i]);
            if (j != i && distance > 0) least = std::min(least, distance);
        }
        if (std::isfinite(least)) sum += least, asked += 1;
    }
    return asked > 0 ? sum / asked : 0;
}

void add_box(const Scene& scene, Shape& shape) {
    const Vec3 box = scene.box.value();
    if (box.x == 0 || box.x != box.y || box.y != box.z) return;
    shape.period = box.x;
    if (scene.corner) {
        shape.corner = scene.corner->value();
    } else {
        Vec3 low = shape.rest.front(), high = low;
        for (const Vec3 at : shape.rest) {
            low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
            high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
        }
        shape.corner = low - 0.5 * (box - (high - low));
    }
    shape.expected = {shape.corner, shape.corner + box};
}

}  // namespace

Shape shape_of(const Scene& scene) {
    const SceneParticles particles(scene);
    const bool roaming = scene.springs.empty() || !scene.pairs.empty();
    Shape shape;
    for (std::size_t i = 0; i < particles.count(); ++i) {
        const SceneParticle particle = particles[i];
        shape.rest.push_back(roaming ? particle.position + particle.displacement : particle.position);
        shape.roles.push_back(particle.role);
        shape.expected.push_back(particle.position + particle.displacement);
    }
    for (const SpringTerm& term : scene.springs) {
        each_spring(particles, term, [&](const ScenePair& pair) {
            const double rest = length(particles[pair.second].position - particles[pair.first].position);
            shape.springs.push_back({static_cast<std::uint32_t>(pair.first), static_cast<std::uint32_t>(pair.second),
                                     term.length ? term.length->value : rest});
        });
    }
    const double apart = shape.springs.empty() ? mean_nearest(shape.rest) : mean_spring(shape);
    shape.spacing = apart > 0 ? apart : 1;
    add_box(scene, shape);
    return shape;
}

}  // namespace steplab
