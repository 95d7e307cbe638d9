#pragma once

#include "core/vec3.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace steplab {

/// The reference positions of a scene: `count` points in rows of `columns`, the first one at the origin; or any points.
struct Lattice {
    std::size_t count = 0;
    std::size_t columns = count;                                ///< at least 1 where there are points
    Vec3 along_row{};                                           ///< from a point to the next of its row
    Vec3 between_rows{};                                        ///< from a point to the one in the next row
    std::shared_ptr<const std::vector<Vec3>> points = nullptr;  ///< each of them; null for rows

    Vec3 at(std::size_t i) const { return points ? (*points)[i] : at(i / columns, i % columns); }
    Vec3 at(std::size_t row, std::size_t column) const {
        return static_cast<double>(column) * along_row + static_cast<double>(row) * between_rows;
    }

    /// Calls visit(i, at(i)) for `number` points from index `first` on, in order.
    template <class Visit>
    void each(std::size_t first, std::size_t number, const Visit& visit) const {
        if (number == 0) return;
        std::size_t row = first / columns, column = first % columns;
        for (std::size_t i = first; i < first + number; ++i) {
            visit(i, points ? (*points)[i] : at(row, column));
            if (++column < columns) continue;
            column = 0;
            ++row;
        }
    }
};

}  // namespace steplab
