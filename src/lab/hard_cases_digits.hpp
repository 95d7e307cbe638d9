#pragma once

#include "lab/hard_case.hpp"

namespace steplab {

// Where digits, or the time that steps take, run out.

/// A rope so stiff that its fastest motion is a thousandth of what one wants to see: whipping, and coming to rest.
HardCase stiff_rope();
/// Many steps of an oscillator: the phase that its method loses, and what rounding adds.
HardCase long_time();
/// Float steps shorter than half an ulp of the position.
HardCase stagnation();
/// Motion that decays below the smallest normal number.
HardCase decay_to_zero();
/// A rope that whips without drag: errors grow with the Lyapunov exponent.
HardCase chaos();

}  // namespace steplab
