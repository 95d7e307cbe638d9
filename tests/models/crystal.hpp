#pragma once

#include "models/model.hpp"

namespace steplab {

/// A warm cube of particles in a space that repeats itself, with Morse forces up to a cut-off: no model of the
/// catalogue yet, as the force jumps at the cut-off, which methods that keep a tolerance follow in tiny steps.
const Model& crystal_model();

}  // namespace steplab
