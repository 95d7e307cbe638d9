#pragma once

#include "core/shape.hpp"
#include "render/style.hpp"

#include <array>
#include <cstdint>

namespace steplab::render {

/// A colour in sRGB.
struct Rgb {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    friend bool operator==(const Rgb&, const Rgb&) = default;
};

constexpr Rgb rgb(std::uint32_t hex) {
    return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8), static_cast<std::uint8_t>(hex)};
}

/// A part of a colour map, from 0, its beginning, to 1.
struct MapPart {
    double low = 0;
    double high = 1;
};

/// The colours of a drawing.
struct Palette {
    Rgb top, bottom;  ///< of the background
    Rgb grid;         ///< lines on the ground, axes
    Rgb text;         ///< numbers and titles
    Rgb spring;
    Rgb neutral;                            ///< moving particles where springs are coloured by strain
    Rgb selection;                          ///< ring around the selected particle
    Rgb force;                              ///< arrows of forces
    std::array<Rgb, 4> roles;               ///< by Role
    std::array<Rgb, 3> axes;                ///< x, y, z of the small cross
    std::array<Rgb, 4> runs;                ///< of a session, by swatch
    MapPart values;                         ///< of viridis: the scale of values
    Rgb compressed, unstrained, stretched;  ///< ends and middle of the scale of strain
    double sky, earth;                      ///< ambient light from above and below, 0 .. 1
};

const Palette& palette(Background background);
/// The background at a part of the picture's height, from its bottom.
Rgb backdrop_at(const Palette& palette, double part);

/// Opacity of what lies between a text and the scene.
inline constexpr double veil = 0.9;

}  // namespace steplab::render
