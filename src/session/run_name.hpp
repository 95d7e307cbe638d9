#pragma once

#include "sim/run/run_description.hpp"

#include <string>

namespace steplab {

/// "rk4, dt 0.1 s, double": a short name of a run beside others of its scene, with the tolerance in place of dt where
/// the method chooses its steps, and the parameters of the scene that differ from those of the leading run.
std::string run_name(const RunDescription& run, const RunDescription& leading);

}  // namespace steplab
