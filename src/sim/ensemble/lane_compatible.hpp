#pragma once

#include "sim/steppers/stepper.hpp"

namespace steplab {

/// True if two runs of one method and precision take the same way through its code: they differ in numbers alone, and
/// none of these is zero in one of them where it decides that something is not computed at all.
bool lane_compatible(const StepperSetup& a, const StepperSetup& b);

/// True if there may be a group of such runs: their forces can be computed in lanes, and as many states as have room in
/// registers stay in the second-level cache. In larger scenes a run alone fills registers and caches better.
bool fits_lanes(const StepperSetup& run);

}  // namespace steplab
