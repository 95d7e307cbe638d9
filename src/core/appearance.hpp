#pragma once

#include "core/vec3.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace steplab {

// The words that say how a scene is shown: the same in scene files, on the command line and in menus.

/// The quantity shown by the colours of particles, or of springs (strain).
enum class Colouring : std::uint8_t { role, speed, kinetic_energy, displacement, strain, group };

inline constexpr std::array<std::string_view, 6> colouring_ids = {"role",         "speed",  "kinetic-energy",
                                                                  "displacement", "strain", "group"};
constexpr std::string_view id(Colouring colouring) { return colouring_ids[static_cast<std::size_t>(colouring)]; }

enum class Background : std::uint8_t { dark, light };

inline constexpr std::array<std::string_view, 2> background_ids = {"dark", "light"};
constexpr std::string_view id(Background background) { return background_ids[static_cast<std::size_t>(background)]; }

/// The groups in which models and scenes are shown, the first for those who begin.
inline constexpr std::array<std::string_view, 5> topic_ids = {"first steps", "springs", "molecules", "planets",
                                                              "hard cases"};

/// The colouring or background of a word. Throws UsageError that names the known ones.
Colouring colouring_of(std::string_view word);
Background background_of(std::string_view word);

/// Cameras are no nearer to their focus than the first, and no farther from it or from the origin than the second:
/// squares and quotients of such lengths are numbers of double.
inline constexpr double least_distance = 1e-99;
inline constexpr double largest_length = 1e102;

/// A camera as text says it: one of the words default, front, side and top, or numbers.
struct WrittenView {
    std::string_view word = {};  ///< empty: the numbers hold
    double yaw = 0, pitch = 0;   ///< degrees
    double distance = 1;
    Vec3 focus = {};
};

/// Reads "top" or "yaw,pitch,distance,x,y,z". Throws UsageError that begins with `name` and describes the valid forms.
WrittenView parse_view(std::string_view text, std::string_view name);

}  // namespace steplab
