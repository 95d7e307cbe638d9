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

/// Computes the first of these runs in SIMD lanes, as many as there are lanes; none if they do not fit lanes. A run
/// that diverges, or may do so, has no result: it has to be computed alone.
std::vector<std::optional<EnsembleResult>> run_in_lanes(std::span<const EnsembleRun> runs, std::uint64_t every,
                                                        const Execution& execution, const StepsDone& done);

}  // namespace steplab
