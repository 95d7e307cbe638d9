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
    std::vector<Role> roles;     ///< one per particle
    std::vector<double> masses;  ///< one per particle; empty: all are equal, or not known
    std::vector<std::uint16_t>
        groups;                   ///< one per particle, numbered as they first appear; empty: there is one at most
    std::vector<Spring> springs;  ///< empty where there are no springs
    double spacing = 1;           ///< typical distance between neighbours, > 0; sets the size of drawn objects
    std::vector<Vec3>
        expected;  ///< positions the motion is expected to reach: the initial view and the axes include them
    Vec3 box;      ///< sides of the periodic box; 0: no periodic boundary conditions along this axis
    Vec3 corner;   ///< corner of that box with the smallest coordinates

    bool is_periodic() const { return box != Vec3{}; }
    /// The position as drawn: with periodic boundary conditions, its image inside the box.
    Vec3 seen(Vec3 position) const {
        const auto within = [](double at, double least, double side) {
            return side == 0 ? at : at - side * std::floor((at - least) / side);
        };
        return {within(position.x, corner.x, box.x), within(position.y, corner.y, box.y),
                within(position.z, corner.z, box.z)};
    }
    /// The way from one particle to the nearest image of another, given the way to that one.
    Vec3 nearest(Vec3 way) const {
        const auto shortest = [](double along, double side) {
            return side == 0 ? along : along - side * std::round(along / side);
        };
        return {shortest(way.x, box.x), shortest(way.y, box.y), shortest(way.z, box.z)};
    }
};

}  // namespace steplab
