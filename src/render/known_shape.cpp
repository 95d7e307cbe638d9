#include "render/known_shape.hpp"

#include <utility>

namespace steplab::render {

KnownShape::KnownShape(std::shared_ptr<const Shape> given)
    : shape(std::move(given)), expected(expected_bounds(*shape)), sizes(expected, shape->spacing) {
    for (std::uint32_t i = 0; i < shape->roles.size(); ++i) {
        if (shape->roles[i] != Role::moving) special.push_back(i);
    }
}

}  // namespace steplab::render
