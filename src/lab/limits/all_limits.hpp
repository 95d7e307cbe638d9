#pragma once

#include "lab/limits/limits.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace steplab {

/// The limits of these methods on the scene of `lab`, computed in parallel. For a method that cannot run the scene, the
/// note says why. `done` is called with the number found so far, every few steps, by any thread, but one at a time; an
/// exception it throws ends the search. Throws Interrupted.
std::vector<Limit> all_limits(const StabilityLab& lab, std::span<const RunDescription> methods,
                              const std::function<void(std::size_t)>& done);

}  // namespace steplab
