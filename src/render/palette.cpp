#include "render/palette.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace steplab::render {
namespace {

// Blue against orange, red only with a shape of its own: readable with every kind of colour blindness. `values` and
// the colours of strain have a contrast of 3 or more (WCAG 2.1, graphics) on all of the background.
constexpr Palette dark{.top = rgb(0x161b22),
                       .bottom = rgb(0x0d1117),
                       .grid = rgb(0x8b98a9),
                       .text = rgb(0xa9b4c2),
                       .spring = rgb(0x737e8c),
                       .neutral = rgb(0x59636f),
                       .selection = rgb(0xffffff),
                       .force = rgb(0xd68cf0),
                       .roles = {rgb(0x4c9bf5), rgb(0x828c99), rgb(0xf5b83d), rgb(0xf0645a)},
                       .axes = {rgb(0xe8736c), rgb(0x5fbf77), rgb(0x5c9ce6)},
                       .runs = {rgb(0x4ea1ff), rgb(0xf0994a), rgb(0x54c68a), rgb(0xd98be0)},
                       .values = {0.36, 1},
                       .compressed = rgb(0x3d8bff),
                       .unstrained = rgb(0x737e8c),
                       .stretched = rgb(0xff9a3d),
                       .sky = 0.48,
                       .earth = 0.26};
constexpr Palette light{.top = rgb(0xffffff),
                        .bottom = rgb(0xe9edf2),
                        .grid = rgb(0x5a6675),
                        .text = rgb(0x475261),
                        .spring = rgb(0x98a2af),
                        .neutral = rgb(0x76818e),
                        .selection = rgb(0x10151c),
                        .force = rgb(0x9a3fc4),
                        .roles = {rgb(0x2f7fe0), rgb(0x8c96a3), rgb(0xe8a413), rgb(0xe0483e)},
                        .axes = {rgb(0xb8352d), rgb(0x1c7437), rgb(0x2562b3)},
                        .runs = {rgb(0x1b69cf), rgb(0xb35900), rgb(0x127043), rgb(0x9a2fa8)},
                        .values = {0, 0.52},
                        .compressed = rgb(0x1464dc),
                        .unstrained = rgb(0x76818e),
                        .stretched = rgb(0xd96500),
                        .sky = 0.62,
                        .earth = 0.42};

}  // namespace

const Palette& palette(Background background) { return background == Background::dark ? dark : light; }

Rgb backdrop_at(const Palette& palette, double part) {
    const auto mixed = [part](std::uint8_t low, std::uint8_t high) {
        return static_cast<std::uint8_t>(std::lround(std::lerp(low, high, std::clamp(part, 0.0, 1.0))));
    };
    const auto& [low, high] = std::pair(palette.bottom, palette.top);
    return {mixed(low.red, high.red), mixed(low.green, high.green), mixed(low.blue, high.blue)};
}

}  // namespace steplab::render
