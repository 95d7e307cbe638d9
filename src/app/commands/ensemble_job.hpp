#pragma once

#include "app/commands/run_outputs.hpp"
#include "sim/ensemble/ensemble.hpp"
#include "sim/ensemble/parameter_range.hpp"
#include "sim/run/execution.hpp"

#include <cstdint>
#include <vector>

namespace steplab {

/// What `run --ensemble` is to do.
struct EnsembleJob {
    std::vector<ParameterRange> ranges;
    std::vector<EnsembleRun> runs;  ///< one at least
    std::uint64_t every = 1;
    OutputOptions output;
    Execution execution;

    /// Computes the runs, writes what was asked for and tells how it went. Throws Error with the exit code of a
    /// diverged run if one did, UsageError, FileError and Interrupted.
    void run() const;
};

}  // namespace steplab
