#pragma once

#include "app/commands/run_outputs.hpp"
#include "sim/ensemble/ensemble.hpp"
#include "sim/ensemble/parameter_range.hpp"
#include "sim/run/execution.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// The work of `run --ensemble`.
struct EnsembleJob {
    std::vector<ParameterRange> ranges;
    std::vector<EnsembleRun> runs;  ///< one at least
    std::uint64_t every = 1;
    std::optional<std::string> note_of_end = {};  ///< where the longest run ends elsewhere than asked
    OutputOptions output;
    Execution execution;

    /// Runs the ensemble, writes its files and prints a summary. Throws Error with the exit code of a diverged run if a
    /// run diverged, UsageError, FileError and Interrupted.
    void run() const;
};

}  // namespace steplab
