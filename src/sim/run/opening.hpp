#pragma once

#include "sim/run/run_description.hpp"

namespace steplab {

/// The scene of this description as the window opens it: with the method that its model recommends, and the dt. The
/// precision stays.
RunDescription opening(RunDescription scene);

/// The dt that the model of this description recommends, shorter where its parameters make the scene faster than the
/// default one.
double opening_dt(const RunDescription& scene);

/// A scene file that was changed, of which `fresh` is a new description: method, dt, precision and parameters that
/// `now` has otherwise than its file says stay, where the new file has room for them; all else is the new file's.
RunDescription reloaded(const RunDescription& now, RunDescription fresh);

}  // namespace steplab
