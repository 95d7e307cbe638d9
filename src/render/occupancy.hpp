#pragma once

#include "render/camera.hpp"

#include <cstdint>
#include <vector>

namespace steplab::render {

/// The parts of a picture that particles cover, in cells of a few pixels: texts fade there.
class Occupancy {
public:
    explicit Occupancy(PictureSize size);
    /// Marks a disc as covered.
    void mark(PixelPoint centre, double radius);
    /// The covered part of a rectangle's cells, 0 .. 1.
    double taken(PixelPoint low, PixelPoint high) const;

private:
    static constexpr int cell = 8;  ///< pixels

    int columns_, rows_;
    std::vector<std::uint8_t> cells_;
};

}  // namespace steplab::render
