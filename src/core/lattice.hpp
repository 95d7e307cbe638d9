#pragma once

#include "core/vec3.hpp"

#include <cstddef>

namespace steplab {

/// The reference positions of a scene: `count` points in rows of `columns`, the first one at the origin.
struct Lattice {
    std::size_t count = 0;
    std::size_t columns = count;  ///< at least 1 where there are points
    Vec3 along_row{};             ///< from a point to the next of its row
    Vec3 between_rows{};          ///< from a point to the one in the next row

    Vec3 at(std::size_t i) const {
        const std::size_t row = i / columns, column = i % columns;
        return static_cast<double>(column) * along_row + static_cast<double>(row) * between_rows;
    }
};

}  // namespace steplab
