#pragma once

#include "core/shape.hpp"
#include "render/bounds.hpp"
#include "render/drawn_sizes.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace steplab::render {

/// Properties of a shape that every picture needs, computed once.
struct KnownShape {
    explicit KnownShape(std::shared_ptr<const Shape> shape);

    std::shared_ptr<const Shape> shape;
    Bounds expected;
    DrawnSizes sizes;
    std::vector<std::uint32_t> special;  ///< particles that are drawn individually: all but Role::moving
    /// Sizes by mass, relative to that of the heaviest; empty: all are equal. Volumes are as masses, within a range in
    /// which the lightest are seen.
    std::vector<float> parts;

    /// The radius of the heaviest particle of a role.
    double largest_radius(Role role) const;
    /// Part of largest_radius() that a particle has.
    float part(std::size_t particle) const { return parts.empty() ? 1 : parts[particle]; }
};

}  // namespace steplab::render
