#include "render/drawn_sizes.hpp"

#include <algorithm>

namespace steplab::render {
namespace {

constexpr double usual_part = 0.19;      // of the spacing of neighbours
constexpr double largest_part = 0.25;    // of the spacing of neighbours
constexpr double part_of_scene = 0.014;  // of the scene's diagonal

}  // namespace

DrawnSizes::DrawnSizes(const Shape& shape) : DrawnSizes(expected_bounds(shape), shape.spacing) {}

DrawnSizes::DrawnSizes(const Bounds& expected, double spacing) {
    const double wanted = part_of_scene * length(expected.size());
    ball_ = std::clamp(wanted, usual_part * spacing, largest_part * spacing);
}

double DrawnSizes::radius(Role role) const {
    constexpr double by_role[] = {1, 1.0, 1.25, 1.5};
    return by_role[static_cast<std::size_t>(role)] * ball_;
}

}  // namespace steplab::render
