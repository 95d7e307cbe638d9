#pragma once

#include "models/plan.hpp"
#include "sim/run/run_description.hpp"

#include <string>
#include <vector>

namespace steplab {

/// What may help a run that diverged, as linear theory has it: each is clearly below the stability limit and keeps the
/// motion (Resolution), judged at a largest frequency and at that of the motion that the scene starts with.
struct RemedyCandidates {
    std::vector<double> dts;           ///< smaller ones for the same method, the largest first
    std::vector<std::string> methods;  ///< ids of other explicit methods for the same dt, the cheapest first
};

/// Of a run on this scene, whose fastest oscillation is to be `omega` [rad/s]; 0 = not known: then parts of dt alone.
/// Nothing for a method that chooses its own steps. Takes up to some hundred milliseconds with drag, and memory for
/// some states of the scene.
RemedyCandidates remedy_candidates(const RunDescription& run, const Plan& scene, double omega);

}  // namespace steplab
