#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace steplab::render {

/// The quantity shown by the colours of particles, or of springs (strain).
enum class Colouring : std::uint8_t { role, speed, kinetic_energy, displacement, strain };

inline constexpr std::array<std::string_view, 5> colouring_ids = {"role", "speed", "kinetic-energy", "displacement",
                                                                  "strain"};
constexpr std::string_view id(Colouring colouring) { return colouring_ids[static_cast<std::size_t>(colouring)]; }

enum class Background : std::uint8_t { dark, light };

inline constexpr std::array<std::string_view, 2> background_ids = {"dark", "light"};
constexpr std::string_view id(Background background) { return background_ids[static_cast<std::size_t>(background)]; }

/// Options of drawing a scene.
struct Style {
    Colouring colouring = Colouring::role;
    Background background = Background::dark;
    bool springs = true;
    bool grid = true;                          ///< ground grid, axes with their numbers, and the small xyz cross
    bool legend = true;                        ///< for the colour scale, if there is one
    std::optional<std::size_t> selected = {};  ///< particle to mark
    double mass = 1;                           ///< of each particle; for its kinetic energy
    /// Value at the upper end of the colour scale; none: the next nice number above the largest value of the frame.
    std::optional<double> scale_maximum = {};
    double pixel_scale = 1;  ///< pixels per unit of the layout: scales text and lines

    friend bool operator==(const Style&, const Style&) = default;
};

}  // namespace steplab::render
