#include "render/following.hpp"

#include "render/bounds.hpp"

namespace steplab::render {
namespace {

std::optional<Vec3> centre_of_mass(const Frame& frame) {
    const Shape& shape = *frame.shape;
    Vec3 sum;
    double mass = 0;
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        if (shape.roles[i] == Role::fixed) continue;
        const double own = shape.masses.empty() ? 1 : shape.masses[i];
        sum = sum + own * frame.drawn(i);
        mass += own;
    }
    return mass > 0 ? std::optional((1 / mass) * sum) : std::nullopt;
}

}  // namespace

std::optional<Vec3> followed_point(const Frame& frame, Following following, std::optional<std::size_t> selected) {
    std::optional<Vec3> point;
    if (following == Following::centre) point = centre_of_mass(frame);
    if (following == Following::particle && selected && *selected < frame.positions.size())
        point = frame.seen(*selected);
    return point && drawable(*point) ? point : std::nullopt;
}

}  // namespace steplab::render
