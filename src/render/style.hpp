#pragma once

#include "core/appearance.hpp"
#include "core/vec3.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace steplab::render {

using steplab::Background;
using steplab::background_ids;
using steplab::Colouring;
using steplab::colouring_ids;

/// Options of drawing a scene.
struct Style {
    Colouring colouring = Colouring::role;
    Background background = Background::dark;
    bool springs = true;
    bool grid = true;                          ///< ground grid, axes with their numbers, and the small xyz cross
    bool legend = true;                        ///< for the colour scale, if there is one
    bool velocities = false;                   ///< as arrows
    std::optional<std::size_t> selected = {};  ///< particle to mark
    std::shared_ptr<const std::vector<Vec3>> trail = {};  ///< where it has been; null: not drawn
    double mass = 1;                                      ///< of each particle; for its kinetic energy
    /// Value at the upper end of the colour scale; none: the next nice number above the largest value of the frame.
    std::optional<double> scale_maximum = {};
    double pixel_scale = 1;  ///< pixels per unit of the layout: scales text and lines

    friend bool operator==(const Style&, const Style&) = default;
};

}  // namespace steplab::render
