#pragma once

#include "sim/run/run_description.hpp"

#include <optional>

namespace steplab::ui {

/// The description with another time step.
RunDescription with_dt(RunDescription description, double dt);

/// The same scene and dt with the cheapest other explicit method for which dt is clearly below the stability limit.
/// None if there is none or the limits are not known.
std::optional<RunDescription> stable_method(const RunDescription& description);

}  // namespace steplab::ui
