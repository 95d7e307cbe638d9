#pragma once

#include "lab/hard_cases/hard_case.hpp"

namespace steplab {

// Difficult choices of dt.

/// An oscillator at 0.999 and 1.001 of every method's stability limit, a million steps.
HardCase marginal_steps();
/// An oscillator whose dt changes during the run: once, or every quarter of its period.
HardCase changed_steps();
/// Bands of dt in which symplectic methods are unstable, below their final limit.
HardCase step_resonances();
/// Strong drag with methods that have substeps backwards in time.
HardCase backward_steps_with_drag();

}  // namespace steplab
