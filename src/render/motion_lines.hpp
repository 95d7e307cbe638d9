#pragma once

#include "render/instances.hpp"
#include "render/shot.hpp"

#include <vector>

namespace steplab::render {

/// The velocities of all particles as arrows; the longest is about as long as neighbours are apart. Of very many
/// particles, some have one.
std::vector<Rod> velocity_arrows(const Shot& shot);

/// The way that a particle came, fainter the longer ago. In a periodic box it ends where the particle leaves the box,
/// and goes on where it comes in again.
std::vector<Rod> trail_lines(const Shot& shot);

}  // namespace steplab::render
