#include "render/occupancy.hpp"

#include "core/clamped.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::render {
namespace {

int clamped_cell(double pixel, int cell, int count) { return clamped_floor(pixel / cell, 0, count - 1); }

}  // namespace

Occupancy::Occupancy(PictureSize size)
    : columns_(size.width / cell + 1),
      rows_(size.height / cell + 1),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void Occupancy::mark(PixelPoint centre, double radius) {
    if (!std::isfinite(centre.x + centre.y) || std::isnan(radius)) return;  // nowhere in the picture
    if (radius < cell / 2.0) {                                              // smaller than a cell
        if (!(centre.x >= 0 && centre.y >= 0 && centre.x < cell * columns_ && centre.y < cell * rows_)) return;
        const int row = static_cast<int>(centre.y) / cell, column = static_cast<int>(centre.x) / cell;
        const int place = row * columns_ + column;
        cells_[static_cast<std::size_t>(place)] = 1;
        return;
    }
    const int left = clamped_cell(centre.x - radius, cell, columns_);
    const int right = clamped_cell(centre.x + radius, cell, columns_);
    const int top = clamped_cell(centre.y - radius, cell, rows_);
    const int bottom = clamped_cell(centre.y + radius, cell, rows_);
    for (int row = top; row <= bottom; ++row) {
        const auto first = cells_.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
        std::fill(first + left, first + right + 1, std::uint8_t{1});
    }
}

double Occupancy::taken(PixelPoint low, PixelPoint high) const {
    const int left = clamped_cell(low.x, cell, columns_);
    const int right = clamped_cell(high.x, cell, columns_);
    const int top = clamped_cell(low.y, cell, rows_);
    const int bottom = clamped_cell(high.y, cell, rows_);
    int taken = 0;
    for (int row = top; row <= bottom; ++row) {
        for (int column = left; column <= right; ++column) {
            taken += cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                            static_cast<std::size_t>(column)];
        }
    }
    // ends that are not numbers may be in any order
    return right < left || bottom < top ? 0 : static_cast<double>(taken) / ((right - left + 1) * (bottom - top + 1));
}

}  // namespace steplab::render
