#pragma once

#include "lab/limits/limits.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace steplab {

/// The limits of these methods on the scene of `lab`, several at a time on as many processors. A method that cannot run
/// the scene is no reason to tell nothing of the others: its note says why. `done` hears, from any of the threads but
/// one at a time, how many are found; what it throws ends the search. Throws Interrupted.
std::vector<Limit> all_limits(const StabilityLab& lab, std::span<const RunDescription> methods,
                              const std::function<void(std::size_t)>& done);

}  // namespace steplab
