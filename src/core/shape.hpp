#pragma once

#include "core/vec3.hpp"

#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

namespace steplab {

/// What a particle is in its scene; drawn apart by colour and shape.
enum class Role : std::uint8_t { moving, fixed, kicked, bullet };

constexpr std::string_view id(Role role) {
    constexpr std::string_view ids[] = {"moving", "fixed", "kicked", "bullet"};
    return ids[static_cast<std::size_t>(role)];
}

/// A spring between two particles, by their indices.
struct Spring {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    double rest_length = 0;
};

/// What of a scene never changes while it runs: shared by all frames of a run, plain data.
struct Shape {
    std::vector<Vec3> rest;       ///< rest position of each particle; where there is none (free, morse) its start
    std::vector<Role> roles;      ///< one per particle
    std::vector<Spring> springs;  ///< empty where particles act on each other without springs
    double spacing = 1;           ///< typical distance of neighbours, > 0; sizes of drawn things follow it
    std::vector<Vec3> expected;   ///< places it is expected to reach; the first camera and the axes take them in
    double period = 0;            ///< not 0: space repeats itself after this length along each axis
    Vec3 corner;                  ///< then the least corner of the box in which everything is seen

    /// Where a position is seen: with a period, the image of it that is in the box.
    Vec3 seen(Vec3 position) const {
        if (period == 0) return position;
        const auto within = [this](double at, double least) { return at - period * std::floor((at - least) / period); };
        return {within(position.x, corner.x), within(position.y, corner.y), within(position.z, corner.z)};
    }
};

}  // namespace steplab
