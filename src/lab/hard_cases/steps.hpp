#pragma once

#include "lab/hard_cases/hard_case.hpp"

namespace steplab {

// Hard choices of dt.

/// An oscillator at 0.999 and 1.001 of every method's limit, a million steps.
HardCase marginal_steps();
/// An oscillator whose dt is changed on the way: once, and at every quarter of its period.
HardCase changed_steps();
/// Bands of dt in which symplectic methods are unstable below where they finally fail.
HardCase step_resonances();
/// Strong drag under methods that step backwards in time.
HardCase backward_steps_with_drag();

}  // namespace steplab
