#pragma once

#include "core/lattice.hpp"
#include "core/start.hpp"
#include "models/forces/forces.hpp"

#include <vector>

namespace steplab {

/// How a scene is stepped: the layout of its forces and where it starts, everything in double.
struct Plan {
    double mass = 1;  ///< of each particle, > 0; where they differ, the unit of `masses`
    double drag = 0;  ///< rate gamma = c / m of the drag -c v, >= 0
    Forces forces;
    Lattice reference;  ///< absolute position = reference + displacement
    Start start;
    std::vector<double> masses = {};  ///< of each particle divided by `mass`; empty where all are 1
};

}  // namespace steplab
