#pragma once

#include "render/instances.hpp"
#include "render/shot.hpp"

#include <vector>

namespace steplab::render {

/// The velocities and the forces of all particles as arrows, in two colours; the longest of each kind is about as long
/// as neighbours are apart. Of very many particles, some have them. What the style does not ask for is left out.
std::vector<Rod> motion_arrows(const Shot& shot);

/// The ways that particles came, fainter the longer ago. In a periodic box a way ends where the particle leaves the
/// box, and goes on where it comes in again.
std::vector<Rod> trail_lines(const Shot& shot);

}  // namespace steplab::render
