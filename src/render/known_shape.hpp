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
};

}  // namespace steplab::render
