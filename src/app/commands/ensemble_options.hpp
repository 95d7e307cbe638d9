#pragma once

#include "app/cli/scene_options.hpp"
#include "sim/ensemble/ensemble.hpp"
#include "sim/ensemble/parameter_range.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace steplab {

/// The options of `run` that make many runs of one: --ensemble and --spread.
class EnsembleOptions {
public:
    void declare(CLI::App& app);
    /// Whether there are several runs to compute. Throws UsageError if --spread stands alone.
    bool asked() const;
    /// How many there are. Throws UsageError.
    std::size_t count() const;
    /// What differs, as a person gave it. Throws UsageError.
    std::vector<ParameterRange> ranges(const RunDescription& description) const;
    /// The runs, checked. Throws UsageError.
    std::vector<EnsembleRun> runs(const RunDescription& description, const std::vector<ParameterRange>& ranges,
                                  const TimeOptions& time) const;

private:
    std::string count_;
    std::vector<std::string> ranges_;
};

}  // namespace steplab
