#pragma once

#include "lab/hard_cases/hard_case.hpp"

namespace steplab {

// Ropes: stiff ones, and the growth of errors in a whipping one.

/// A rope so stiff that its fastest motion is a thousand times faster than the motion of interest: whipping, and coming
/// to rest.
HardCase stiff_rope();
/// A rope that whips without drag: errors grow exponentially, with the Lyapunov exponent.
HardCase chaos();

}  // namespace steplab
