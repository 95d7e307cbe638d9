#pragma once

#include "lab/hard_cases/hard_case.hpp"

namespace steplab {

// Limits of precision.

/// Many steps of an oscillator: the phase errors of the method and of rounding.
HardCase long_time();
/// Float steps shorter than half an ulp of the position.
HardCase stagnation();
/// Motion that decays below the smallest normal number.
HardCase decay_to_zero();

}  // namespace steplab
