#pragma once

#include "render/camera.hpp"

#include <cstdint>
#include <vector>

namespace steplab::render {

/// Which parts of a picture particles are drawn in, in cells of some pixels: what is written there would be in the way.
class Occupancy {
public:
    explicit Occupancy(PictureSize size);
    /// A disc is drawn here.
    void mark(PixelPoint centre, double radius);
    /// Part of a rectangle's cells that are taken, 0 .. 1.
    double taken(PixelPoint low, PixelPoint high) const;

private:
    static constexpr int cell = 8;  ///< pixels

    int columns_, rows_;
    std::vector<std::uint8_t> cells_;
};

}  // namespace steplab::render
