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

using Trails = std::vector<std::vector<Vec3>>;

/// Options of drawing a scene.
struct Style {
    Colouring colouring = Colouring::role;
    Background background = Background::dark;
    bool springs = true;
    bool grid = true;                          ///< ground grid, axes with their numbers, and the small xyz cross
    bool legend = true;                        ///< for the colour scale, if there is one
    bool velocities = false;                   ///< as arrows
    bool forces = false;                       ///< as arrows, if the frame has them
    std::optional<std::size_t> selected = {};  ///< particle to mark
    /// Where it and particles selected before have been, the newest place of each last; null: not drawn.
    std::shared_ptr<const Trails> trails = {};
    double mass = 1;  ///< of each particle; for its kinetic energy
    /// Value at the upper end of the colour scale; none: the next nice number above the largest value of the frame.
    std::optional<double> scale_maximum = {};
    double pixel_scale = 1;  ///< pixels per unit of the layout: scales text and lines

    friend bool operator==(const Style&, const Style&) = default;
};

}  // namespace steplab::render
