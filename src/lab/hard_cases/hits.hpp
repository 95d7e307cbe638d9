#pragma once

#include "lab/hard_cases/hard_case.hpp"

namespace steplab {

// Particles that meet, pass each other or part for good.

/// A short chain kicked so hard that neighbours pass each other.
HardCase passing_neighbours();
/// A mesh kicked so hard that it folds.
HardCase folding_mesh();
/// Two Morse particles that pass each other closely, and head on.
HardCase grazing_hits();
/// Two Morse particles whose energy is exactly that of escape.
HardCase escape_threshold();
/// Two Morse particles pressed together to a thousand times the well's depth.
HardCase deep_repulsion();
/// The Morse cube of spacing 0.5, whose mirror pairs collide head on.
HardCase colliding_cube();
/// Particles at one place, and a billionth apart.
HardCase coincident_particles();

}  // namespace steplab
