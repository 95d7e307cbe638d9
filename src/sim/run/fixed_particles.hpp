#pragma once

#include "models/forces/forces.hpp"

#include <cstddef>

namespace steplab {

/// True if a particle of a scene is held where it is.
bool is_fixed(const Forces& forces, std::size_t particle);

}  // namespace steplab
