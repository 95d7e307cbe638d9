#pragma once

#include "lab/study/speed_error.hpp"

#include <vector>

namespace steplab {

/// What to take for a scene, a time and an error.
struct Advice {
    Measurement best;                 ///< verified: run once more as its command line says, its error holds
    std::vector<Measurement> others;  ///< the best run of every other method that reached the error, fastest first
};

/// Looks for the largest dt or tolerance of every method and precision of the plan that still keeps the error, times
/// these runs and runs the fastest once more. Throws UsageError, naming the least error that was reached, if none keeps
/// it.
Advice advise(const StudyPlan& plan, double error, const Reference& reference, const StudyProgress& progress);

}  // namespace steplab
