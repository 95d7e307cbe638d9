#pragma once

#include "core/frame.hpp"
#include "core/vec3.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace steplab::render {

/// What the camera goes with.
enum class Following : std::uint8_t { nothing, particle, centre };

/// The point that it goes with: the selected particle as drawn, or the centre of mass of all that are not fixed. None
/// where there is no such point.
std::optional<Vec3> followed_point(const Frame& frame, Following following, std::optional<std::size_t> selected);

}  // namespace steplab::render
