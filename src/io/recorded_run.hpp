#pragma once

#include "io/summary.hpp"
#include "sim/run/short_walks.hpp"
#include "sim/run/simulation.hpp"

#include <cstdint>
#include <functional>

namespace steplab {

/// Runs a simulation from its start and calls record(simulation) at the start, after every K-th step and at the end. Of
/// a run that diverges only valid steps are recorded. `between` is called with the present step on the way; what it
/// throws ends the run.
RunSummary record_run(Simulation& simulation, const RunEnd& end, std::uint64_t every,
                      const ShortWalks::Between& between, const std::function<void(const Simulation&)>& record);

}  // namespace steplab
