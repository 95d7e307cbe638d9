#include "render/known_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace steplab::render {
namespace {

// Radii in those of a scene of equal masses.
constexpr double heaviest = 1.6, lightest = 0.7;

/// None where all that move have one mass.
std::vector<float> parts_by_mass(const Shape& shape) {
    double largest = 0, least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < shape.masses.size(); ++i) {
        if (shape.roles[i] == Role::fixed) continue;
        largest = std::max(largest, shape.masses[i]);
        least = std::min(least, shape.masses[i]);
    }
    if (least >= largest) return {};
    std::vector<float> parts(shape.masses.size(), 1);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (shape.roles[i] == Role::fixed) continue;
        parts[i] = static_cast<float>(std::clamp(std::cbrt(shape.masses[i] / largest), lightest / heaviest, 1.0));
    }
    return parts;
}

}  // namespace

KnownShape::KnownShape(std::shared_ptr<const Shape> given)
    : shape(std::move(given)), expected(expected_bounds(*shape)), sizes(expected, shape->spacing) {
    for (std::uint32_t i = 0; i < shape->roles.size(); ++i) {
        if (shape->roles[i] != Role::moving) special.push_back(i);
    }
    if (!shape->masses.empty()) parts = parts_by_mass(*shape);
}

double KnownShape::largest_radius(Role role) const {
    const bool by_mass = !parts.empty() && role != Role::fixed;
    return (by_mass ? heaviest : 1) * sizes.radius(role);
}

}  // namespace steplab::render
