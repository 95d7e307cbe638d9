#pragma once

#include "sim/run/run_description.hpp"

#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// What rounding does to a run that goes on all the same, one sentence each; none as a rule: steps so short that they
/// add less than rounding keeps of it, and displacements so large that they no longer resolve the scene's bonds.
/// `farthest`: largest displacement from the reference position, in metres.
std::vector<std::string> notes_of_rounding(const RunDescription& run, const std::optional<StabilityLimit>& limit,
                                           double farthest);

}  // namespace steplab
