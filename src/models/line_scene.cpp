#include "models/line_scene.hpp"

namespace steplab {

Scene line_scene(const LineForces& forces, double drag) {
    const std::size_t n = forces.count;
    Scene scene{.mass = forces.mass,
                .drag = drag,
                .forces = forces,
                .reference = Field<double>(n),
                .start = {Field<double>(n), Field<double>(n)}};
    for (std::size_t i = 0; i < n; ++i) scene.reference.x()[i] = static_cast<double>(i) * forces.rest_length;
    return scene;
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
