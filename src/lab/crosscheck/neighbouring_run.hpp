#pragma once

#include "sim/run/simulation.hpp"

#include <cstdint>

namespace steplab {

/// How a motion amplifies a small change of its start.
struct Amplification {
    double position = 1;  ///< the largest distance of a particle, by that at the start
    double velocity = 0;  ///< the same of velocities, by the distance at the start
};

/// A run and a second one that starts a little beside it.
class NeighbouringRun {
public:
    /// `start` with displacements, and the forces there; the scene's extent is about `size`. Along axes without any
    /// velocity or force, along which rounding does nothing either, it starts as the run does.
    NeighbouringRun(const RunDescription& run, const Frame& start, const std::vector<Vec3>& forces, double size);

    /// Takes it to the step of a moment of the run, and measures how far it is away.
    Amplification at(const Frame& moment);

private:
    double distance_;
    Simulation simulation_;
    Frame frame_;
    Amplification largest_;
};

/// Velocity kicks of rounding count for positions as moves of this many times the kick and dt.
inline constexpr double steps_of_a_kick = 4;

}  // namespace steplab
