#pragma once

#include "sim/ensemble/ensemble.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace steplab {

/// Hears how many steps more have been taken.
using StepsDone = std::function<void(std::uint64_t)>;

/// Computes the first of these runs side by side, as many as have room in a group; none where they do not go so. A run
/// that diverges, or may do so, has no result: it is to be computed by itself.
std::vector<std::optional<EnsembleResult>> run_in_lanes(std::span<const EnsembleRun> runs, std::uint64_t every,
                                                        const Execution& execution, const StepsDone& done);

}  // namespace steplab
