#pragma once

#include "lab/study/speed_error.hpp"

#include <vector>

namespace steplab {

/// The reference is to be this many times as accurate as the requested error.
inline constexpr double finer_reference = 1000;

/// Which method and step to use for a scene, a time and an error.
struct Advice {
    Measurement best;                 ///< verified: repeated as its command line says, it keeps the error
    std::vector<Measurement> others;  ///< the best run of every other method that reached the error, fastest first
};

/// Finds the largest dt or tolerance of every method and precision of the plan that still keeps the error, times these
/// runs and repeats the fastest; `progress` is called in runs, too. Throws UsageError, naming the smallest error that
/// was reached, if none keeps it.
Advice advise(const StudyPlan& plan, double error, const Reference& reference, const StudyProgress& progress);

}  // namespace steplab
