#pragma once

#include "session/session_view.hpp"
#include "sim/run/simulation.hpp"

#include <span>
#include <vector>

namespace steplab {

/// Runs beside one that stands at this time, each at its step there (step_at()). Throws Interrupted.
std::vector<Simulation> runs_at(double time, std::span<const RunDescription> runs);

/// How far they and the leading one are from the motion of their scene. Throws UsageError, Interrupted.
SessionErrors errors_of(const Simulation& leading, std::span<const Simulation> others);

/// Throws an error with code `diverged` that names the runs that did, if any; the leading one is number 0.
void check_ends(const RunView& leading, const std::vector<RunView>& followers);

}  // namespace steplab
