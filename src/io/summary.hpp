#pragma once

#include "sim/run/run_description.hpp"
#include "sim/run/run_result.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// A run and its result.
struct RunSummary {
    RunDescription run;
    RunResult result;  ///< energy_error over the written steps
    double wall_seconds = 0;
    std::optional<double> until = {};  ///< end of the last step, where it is given (RunEnd)
    std::vector<std::string> notes =
        {};  ///< of rounding (sim/run/notes.hpp), and of an end that is not the one asked for
};

/// One JSON object; numbers that are not finite are null. It has the texts of a scene file and of what it reads, and
/// the values that the run starts from. Collisions are in it if there were any: their number, and the times and
/// particles of the first hundred.
std::string summary_json(const RunSummary& summary);
/// A few aligned lines for people: at most 4 significant digits, with units.
std::string summary_text(const RunSummary& summary);

/// The runs of an ensemble and their results.
struct EnsembleSummary {
    struct ParameterRange {
        std::string name;
        double from = 0, to = 0;
    };
    struct Run {
        std::vector<double> values;  ///< of the numbers that are varied, in the order of `ranges`
        RunSummary summary;
    };
    std::vector<ParameterRange> ranges;
    std::vector<Run> runs;  ///< one at least
    double wall_seconds = 0;
    std::vector<std::string> notes = {};  ///< of any run

    /// The number of runs that diverged.
    std::size_t diverged() const;
};

/// One JSON object: what the runs have in common, and `runs`, a list of objects in the order of the runs: the number
/// `run`, the values `set` for it, and the fields of a single run's summary_json() that are not common to all.
std::string summary_json(const EnsembleSummary& summary);
/// A few aligned lines for people.
std::string summary_text(const EnsembleSummary& summary);

}  // namespace steplab
