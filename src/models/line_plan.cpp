#include "models/line_plan.hpp"

#include <cmath>

namespace steplab {

SceneFacts line_facts(const LineForces& forces, double drag) {
    const double ends =
        forces.count == 2 && forces.first_fixed ? 1 : 2;  // that move, of the spring that swings fastest
    return {.mass = forces.mass,
            .drag = drag,
            .bond = forces.rest_length,
            .pair_frequency = std::sqrt(ends * forces.k / forces.mass)};
}

Plan line_plan(const LineForces& forces, double drag, Vec3 kick) {
    return {.mass = forces.mass,
            .drag = drag,
            .forces = forces,
            .reference = {.count = forces.count, .along_row = {forces.rest_length, 0, 0}},
            .start = Start::kick(forces.count, forces.count - 1, kick)};
}

Shape line_shape(std::size_t count, double rest_length, bool first_fixed) {
    Shape shape;
    for (std::size_t i = 0; i < count; ++i) shape.rest.push_back({static_cast<double>(i) * rest_length, 0, 0});
    shape.roles.assign(count, Role::moving);
    if (first_fixed) shape.roles.front() = Role::fixed;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        shape.springs.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1), rest_length});
    }
    shape.spacing = rest_length > 0 ? rest_length : 1;
    return shape;
}

}  // namespace steplab
