#pragma once

#include "lab/hard_cases/hard_case.hpp"

namespace steplab {

// Ropes: stiff ones, and what whipping makes of errors.

/// A rope so stiff that its fastest motion is a thousandth of what one wants to see: whipping, and coming to rest.
HardCase stiff_rope();
/// A rope that whips without drag: errors grow with the Lyapunov exponent.
HardCase chaos();

}  // namespace steplab
