#pragma once

#include "sim/run/run_description.hpp"

#include <optional>

namespace steplab::ui {

/// The description with another time step.
RunDescription with_dt(RunDescription description, double dt);

/// The same scene and dt with the cheapest other method whose stability limit dt keeps a good distance from. None if
/// there is none or the scene's limit is not known.
std::optional<RunDescription> stable_method(const RunDescription& description);

}  // namespace steplab::ui
