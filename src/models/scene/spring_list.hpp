#pragma once

#include "models/scene/scene_particles.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace steplab {

/// A spring of a term between two particles.
struct ScenePair {
    std::size_t first = 0, second = 0;
};

namespace detail {

template <class F>
void each_neighbour(const GridArrangement& grid, std::size_t first, SpringTerm::Along along, F f) {
    const bool axes = along != SpringTerm::Along::diagonals, diagonals = along != SpringTerm::Along::axes;
    const std::size_t columns = grid.columns;
    for (std::size_t row = 0; row < grid.rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t p = first + row * columns + column;
            const bool below = row + 1 < grid.rows, beside = column + 1 < columns;
            if (axes && beside) f(ScenePair{p, p + 1});
            if (axes && below) f(ScenePair{p, p + columns});
            if (diagonals && below && beside) f(ScenePair{p, p + columns + 1});
            if (diagonals && below && column > 0) f(ScenePair{p, p + columns - 1});
        }
    }
}

}  // namespace detail

/// Calls f(pair) for every spring of a term. Throws UsageError if what it names does not exist or has no neighbours.
template <class F>
void each_spring(const SceneParticles& particles, const SpringTerm& term, F f) {
    if (!term.between.empty()) {
        const SceneParticles::Group group = particles.group(term.between);
        if (const auto* grid = std::get_if<GridArrangement>(&group.block.arrangement)) {
            detail::each_neighbour(*grid, group.particles.first, term.along, f);
        } else {
            for (std::size_t i = 0; i + 1 < group.particles.count; ++i)
                f(ScenePair{group.particles.first + i, group.particles.first + i + 1});
        }
    }
    for (const auto& [one, other] : term.pairs) {
        const IndexRange first = particles.named(one), second = particles.named(other);
        f(ScenePair{first.first, second.first});
    }
}

}  // namespace steplab
