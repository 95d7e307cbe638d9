#pragma once

#include "lab/study/reference.hpp"
#include "sim/run/run_description.hpp"

#include <optional>

namespace steplab {

/// The state of the scene at a time > 0 by `dop853` in double, on the forces that runs have: known long before a
/// reference() that is a run in long double, and better than that where a cut-off keeps any method from its order. Its
/// tolerance falls until rounding dominates or the next run would sum more terms than this, a particle or a pair in
/// each evaluation of the force; the difference of the last two runs is the error estimate. None where the method does
/// not take the scene or diverges. The method, precision and dt of the description are ignored. Throws UsageError,
/// Interrupted.
std::optional<Reference> quick_reference(const RunDescription& scene, double time, double most_terms);

}  // namespace steplab
