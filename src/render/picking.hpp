#pragma once

#include "core/frame.hpp"
#include "render/camera.hpp"
#include "render/drawn_sizes.hpp"

#include <cstddef>
#include <optional>

namespace steplab::render {

/// The particle under a pixel, the one nearest to the camera. Particles count as discs of at least `reach` pixels in
/// radius, so that far ones can be selected, too. None if there is no particle.
std::optional<std::size_t> particle_at(const Frame& frame, const Projection& projection, PixelPoint pixel,
                                       double reach = 6);

}  // namespace steplab::render
