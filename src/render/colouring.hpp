#pragma once

#include "core/frame.hpp"
#include "render/palette.hpp"
#include "render/style.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace steplab::render {

/// Viridis, the scale that grows evenly in lightness and reads without colour vision: 0 dark blue, 1 yellow.
/// Values outside 0 .. 1 take the colour of the end.
Rgb viridis(double part);

/// The scale of one colouring, as the legend shows it.
struct ColourScale {
    Colouring colouring = Colouring::displacement;
    double minimum = 0;  ///< 0; -maximum for strain
    double maximum = 1;
    /// The colour of a value; the background's palette gives the middle of the scale of strain.
    Rgb colour(double value, const Palette& palette) const;
};

/// The scale for this frame. None for roles.
std::optional<ColourScale> colour_scale(const Frame& frame, const Style& style);

/// "displacement [m]"
std::string_view title(Colouring colouring);

/// True if the particles have colours by their values, not by their roles.
constexpr bool tells_values(Colouring colouring) {
    return colouring != Colouring::role && colouring != Colouring::strain;
}
/// The colour of all particles of a role, where colours do not tell their values.
Rgb role_colour(const Style& style, Role role);
/// The colour of a particle. Fixed particles keep the colour of their role.
Rgb particle_colour(const Frame& frame, const Style& style, const std::optional<ColourScale>& scale, std::size_t i);
/// The colour of a spring.
Rgb spring_colour(const Frame& frame, const Style& style, const std::optional<ColourScale>& scale, std::size_t i);

}  // namespace steplab::render
