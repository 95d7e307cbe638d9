#pragma once

#include "core/collision.hpp"
#include "core/precision.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// What came of a run.
struct RunSummary {
    std::string model;
    std::string method;
    Precision precision = Precision::double_;
    double dt = 0;            ///< as the precision holds it
    std::uint64_t steps = 0;  ///< taken; up to the last good one
    double time = 0;          ///< reached
    std::size_t particles = 0;
    std::uint64_t evaluations = 0;
    double energy_start = 0;
    double energy_end = 0;
    double energy_error = 0;  ///< largest |E - E0| over the written steps
    bool drag = false;        ///< takes energy: it then changes without any error
    double wall_seconds = 0;
    std::string hash;
    std::optional<std::uint64_t> diverged_step;
    CollisionRecord collisions;  ///< that an adaptive method found and restarted from
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
