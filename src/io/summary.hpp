#pragma once

#include "sim/run/run_description.hpp"
#include "sim/run/run_result.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace steplab {

/// A run and its result.
struct RunSummary {
    RunDescription run;
    RunResult result;  ///< energy_error over the written steps
    double wall_seconds = 0;
};

/// One JSON object with exactly these fields; numbers that are not finite are null. Collisions stand in it if there
/// were any: their number, and time and particles of the first hundred.
std::string summary_json(const RunSummary& summary);
/// A few aligned lines for a person.
std::string summary_text(const RunSummary& summary);

/// What came of several runs of a scene that differ in some numbers.
struct EnsembleSummary {
    struct ParameterRange {
        std::string name;
        double from = 0, to = 0;
    };
    struct Run {
        std::vector<double> values;  ///< of the spread numbers, in their order
        RunSummary summary;
    };
    std::vector<ParameterRange> ranges;
    std::vector<Run> runs;  ///< one at least
    double wall_seconds = 0;

    std::size_t diverged() const;
};

/// One JSON object: what the runs have in common, and `runs`, a list with an object for each in their order: its number
/// `run`, what is `set` for it, and the fields that summary_json() has for a run, but for those in common.
std::string summary_json(const EnsembleSummary& summary);
std::string summary_text(const EnsembleSummary& summary);

}  // namespace steplab
