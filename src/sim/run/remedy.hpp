#pragma once

#include "sim/run/run_description.hpp"

#include <optional>
#include <string>

namespace steplab {

/// For a run that diverged: the id of the cheapest other explicit method for which its dt is clearly below the
/// stability limit of its scene. None if there is none or the limits are not known.
std::optional<std::string> stable_method(const RunDescription& description);

}  // namespace steplab
