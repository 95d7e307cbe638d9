#pragma once

#include "lab/hard_cases/hard_case.hpp"

namespace steplab {

// Where digits run out.

/// Many steps of an oscillator: the phase that its method loses, and what rounding adds.
HardCase long_time();
/// Float steps shorter than half an ulp of the position.
HardCase stagnation();
/// Motion that decays below the smallest normal number.
HardCase decay_to_zero();

}  // namespace steplab
