#pragma once

#include "core/frame.hpp"
#include "render/camera.hpp"
#include "render/drawn_sizes.hpp"

#include <cstddef>
#include <optional>

namespace steplab::render {

/// The particle under a pixel, the one nearest to the camera; where there is none, the one whose edge is nearest to the
/// pixel, at most `tolerance` pixels away. None if there is no such particle. `sizes`: of the frame's shape.
std::optional<std::size_t> particle_at(const Frame& frame, const DrawnSizes& sizes, const Projection& projection,
                                       PixelPoint pixel, double tolerance);

/// True if a particle, or a part of one, is within the picture; other particles may hide it.
bool any_in_view(const Frame& frame, const DrawnSizes& sizes, const Projection& projection);

}  // namespace steplab::render
