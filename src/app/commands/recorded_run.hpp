#pragma once

#include "app/cli/progress.hpp"
#include "io/summary.hpp"
#include "sim/run/simulation.hpp"

#include <cstdint>
#include <functional>

namespace steplab {

/// Takes the steps of a run that has not begun and calls record(simulation) at the first moment, after every K steps
/// and at the end. Of a run that diverges only good steps are recorded.
RunSummary record_run(Simulation& simulation, std::uint64_t steps, std::uint64_t every, Progress& progress,
                      const std::function<void(const Simulation&)>& record);

}  // namespace steplab
