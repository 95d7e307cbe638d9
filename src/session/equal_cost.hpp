#pragma once

#include "sim/run/run_description.hpp"

namespace steplab {

/// Force evaluations of a run per simulated second: known of an explicit method of fixed steps, measured from the start
/// for others. Throws UsageError, Interrupted.
double evaluations_per_second(const RunDescription& run);

/// The run with the dt at which it costs as many force evaluations per simulated second as the other, within a few
/// hundredths; of a method that chooses its own steps with the tolerance that comes nearest. Throws UsageError,
/// Interrupted.
RunDescription at_equal_cost(const RunDescription& run, const RunDescription& other);

}  // namespace steplab
