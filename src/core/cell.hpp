#pragma once

#include "core/vec3.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace steplab {

/// A box whose edges may lean, as files of other programs have it: a parallelepiped that is not flat.
struct Cell {
    std::array<Vec3, 3> edges{};  ///< from its corner
    Vec3 corner{};
    std::array<bool, 3> periodic{true, true, true};  ///< along each edge

    friend bool operator==(const Cell&, const Cell&) = default;

    double volume() const { return dot(edges[0], cross(edges[1], edges[2])); }
    /// False if it is flat, or not of numbers.
    bool is_whole() const { return std::isfinite(1 / volume()); }
    std::array<Vec3, 8> corners() const {
        std::array<Vec3, 8> all{};
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = corner;
            for (std::size_t edge = 0; edge < 3; ++edge) {
                if ((i >> edge & 1U) != 0) all[i] = all[i] + edges[edge];
            }
        }
        return all;
    }
    /// How many of each edge make up a way.
    std::array<double, 3> in_edges(Vec3 way) const {
        const auto& [a, b, c] = edges;
        const double part = 1 / volume();
        return {part * dot(way, cross(b, c)), part * dot(way, cross(c, a)), part * dot(way, cross(a, b))};
    }
    /// The image of a position inside the cell, along its periodic edges.
    Vec3 seen(Vec3 position) const {
        return position - whole_edges(position - corner, [](double number) { return std::floor(number); });
    }
    /// The part of a way that its image nearest to zero along each edge does not have.
    Vec3 through(Vec3 way) const {
        return whole_edges(way, [](double number) { return std::round(number); });
    }

private:
    template <class Whole>
    Vec3 whole_edges(Vec3 way, const Whole& whole) const {
        const std::array<double, 3> numbers = in_edges(way);
        Vec3 sum;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if (periodic[edge]) sum = sum + whole(numbers[edge]) * edges[edge];
        }
        return sum;
    }
};

}  // namespace steplab
