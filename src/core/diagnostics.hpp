#pragma once

#include "core/vec3.hpp"

#include <optional>

namespace steplab {

/// Sums over all particles of one frame, computed in double on request.
struct Diagnostics {
    double kinetic = 0;
    double potential = 0;
    double energy = 0;
    double energy_error = 0;  ///< energy - energy at the start of the baseline, signed
    Vec3 momentum;
    Vec3 angular_momentum;        ///< about the origin
    double max_displacement = 0;  ///< largest |position - rest| of a particle
    double farthest = 0;          ///< largest displacement from the reference position, from which the run counts
    double max_speed = 0;
    std::optional<double> error;  ///< largest distance of a particle from the exact solution, where one is known
};

}  // namespace steplab
