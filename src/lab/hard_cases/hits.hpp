#pragma once

#include "lab/hard_cases/hard_case.hpp"

namespace steplab {

// Particles that collide, pass each other or escape.

/// A short chain kicked so hard that neighbours pass each other.
HardCase passing_neighbours();
/// A mesh kicked so hard that it folds.
HardCase folding_mesh();
/// Two Morse particles that pass each other closely, or head on.
HardCase grazing_hits();
/// Two Morse particles with exactly the escape energy.
HardCase escape_threshold();
/// Two Morse particles that collide with 1000 times the depth of the well.
HardCase deep_repulsion();
/// The Morse cube with spacing 0.5, in which symmetric pairs collide head on.
HardCase colliding_cube();
/// Particles at the same position, and 1e-9 apart.
HardCase coincident_particles();

}  // namespace steplab
