#pragma once

#include "core/frame.hpp"
#include "render/palette.hpp"
#include "render/style.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace steplab::render {

/// The scale of values: what stands out from the background of the viridis colour map, with evenly increasing lightness
/// and readable without colour vision. On dark it goes from blue to yellow, on light from dark violet to green. Parts
/// outside 0 .. 1 have the colour of the nearest end.
Rgb value_colour(double part, const Palette& palette);

/// The colour scale of a colouring, as in the legend.
struct ColourScale {
    Colouring colouring = Colouring::displacement;
    double minimum = 0;                      ///< 0; -maximum for strain; the nice number below the values of a column
    double maximum = 1;                      ///< > minimum
    const ParticleValues* column = nullptr;  ///< of the frame, in place of the colouring
    /// The colour of a value; the scale of strain has a middle of its own.
    Rgb colour(double value, const Palette& palette) const;
};

/// The scale for this frame; none for roles.
std::optional<ColourScale> colour_scale(const Frame& frame, const Style& style);

/// The title of the legend: "displacement [m]", "c_pe".
std::string title(const ColourScale& scale);

/// The column by which the particles of a frame are coloured; null: by the colouring of the style.
const ParticleValues* shown_column(const Frame& frame, const Style& style);

/// What --colour says of how a frame is coloured: "speed", "column:c_pe".
inline constexpr std::string_view column_prefix = "column:";
std::string colour_word(const Frame& frame, const Style& style);

/// True if particles are coloured by a value, not by their role.
constexpr bool shows_values(Colouring colouring) {
    return colouring != Colouring::role && colouring != Colouring::strain && colouring != Colouring::group;
}
/// True if moving particles have colours of their own, by a value or by their group.
inline bool differs_by_particle(const Frame& frame, const Style& style) {
    return shown_column(frame, style) != nullptr || shows_values(style.colouring) ||
           (style.colouring == Colouring::group && !frame.shape->groups.empty());
}
/// The colour of all particles of a role where they are not coloured by a value.
Rgb role_colour(const Style& style, Role role);
/// The colour of a particle. Fixed particles have the colour of their role unless a column of a file is shown; those of
/// which it has no number have a neutral one.
Rgb particle_colour(const Frame& frame, const Style& style, const std::optional<ColourScale>& scale, std::size_t i);
/// The colour of a spring.
Rgb spring_colour(const Frame& frame, const Style& style, const std::optional<ColourScale>& scale, std::size_t i);

}  // namespace steplab::render
