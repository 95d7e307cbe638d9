#pragma once

#include "core/vec3.hpp"

#include <vector>

namespace steplab {

/// The mean distance of a place from the nearest other one, of some hundred of them; 0 if there are no two.
double mean_nearest(const std::vector<Vec3>& places);

}  // namespace steplab
