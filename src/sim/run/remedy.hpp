#pragma once

#include "models/plan.hpp"
#include "sim/run/run_description.hpp"

#include <optional>
#include <string>

namespace steplab {

/// What to change about a run that diverged. Both are clearly below the stability limit of the scene and keep its
/// motion (Resolution), judged at its largest frequency and at that of the motion it starts with.
struct Remedies {
    std::optional<double> dt;           ///< a smaller dt for the same method
    std::optional<std::string> method;  ///< the id of the cheapest other explicit method, for the same dt
};

/// Of a run on this scene, the present one of `run`. Where no limit is known, a quarter of dt alone; nothing for a
/// method that chooses its own steps. Takes up to some hundred milliseconds with drag, and memory for some states of
/// the scene.
Remedies remedies(const RunDescription& run, const Plan& scene);

}  // namespace steplab
