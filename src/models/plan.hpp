#pragma once

#include "core/lattice.hpp"
#include "core/start.hpp"
#include "models/forces/forces.hpp"

namespace steplab {

/// How a scene is stepped: the layout of its forces and where it starts, everything in double.
struct Plan {
    double mass = 1;  ///< of each particle, > 0
    double drag = 0;  ///< rate gamma = c / m of the drag -c v, >= 0
    Forces forces;
    Lattice reference;  ///< absolute position = reference + displacement
    Start start;
};

}  // namespace steplab
