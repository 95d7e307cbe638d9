#pragma once

#include "app/run_outputs.hpp"
#include "sim/ensemble.hpp"
#include "sim/execution.hpp"
#include "sim/spread.hpp"

#include <cstdint>
#include <vector>

namespace steplab {

/// What `run --ensemble` is to do.
struct EnsembleJob {
    std::vector<Spread> spreads;
    std::vector<EnsembleRun> runs;  ///< one at least
    std::uint64_t every = 1;
    OutputOptions output;
    Execution execution;

    /// Computes the runs, writes what was asked for and tells how it went. Throws Error with the exit code of a
    /// diverged run if one did, UsageError, FileError and Interrupted.
    void run() const;
};

}  // namespace steplab
