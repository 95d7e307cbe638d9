#pragma once

#include "sim/run/run_description.hpp"

namespace steplab {

/// The scene of this description as the window opens it: with the method that its model recommends, and the dt. The
/// precision stays.
RunDescription opening(RunDescription scene);

/// The dt that the model of this description recommends, shorter where its parameters make the scene faster than the
/// default one.
double opening_dt(const RunDescription& scene);

}  // namespace steplab
