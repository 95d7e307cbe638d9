#pragma once

#include "core/vec3.hpp"

#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

namespace steplab {

/// The role of a particle in its scene; each has its own colour and shape when drawn.
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

/// The part of a scene that does not change during a run: plain data, shared by all frames of the run.
struct Shape {
    std::vector<Vec3> rest;  ///< rest position of each particle; its initial position where there is none (free, morse)
    std::vector<Role> roles;      ///< one per particle
    std::vector<Spring> springs;  ///< empty where there are no springs
    double spacing = 1;           ///< typical distance between neighbours, > 0; sets the size of drawn objects
    std::vector<Vec3>
        expected;       ///< positions the motion is expected to reach: the initial view and the axes include them
    double period = 0;  ///< side of the periodic box; 0: no periodic boundary conditions
    Vec3 corner;        ///< corner of that box with the smallest coordinates

    /// The position as drawn: with periodic boundary conditions, its image inside the box.
    Vec3 seen(Vec3 position) const {
        if (period == 0) return position;
        const auto within = [this](double at, double least) { return at - period * std::floor((at - least) / period); };
        return {within(position.x, corner.x), within(position.y, corner.y), within(position.z, corner.z)};
    }
};

}  // namespace steplab
