#pragma once

#include "app/cli/scene_options.hpp"
#include "sim/ensemble/ensemble.hpp"
#include "sim/ensemble/parameter_range.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace steplab {

/// The options of an ensemble: --ensemble and --spread.
class EnsembleOptions {
public:
    void declare(CLI::App& app);
    /// True if --ensemble was given. Throws UsageError for --spread without it.
    bool is_given() const;
    /// The number of runs. Throws UsageError.
    std::size_t count() const;
    /// The ranges given by --spread. Throws UsageError.
    std::vector<ParameterRange> ranges(const RunDescription& description) const;
    /// The runs, checked. Throws UsageError.
    std::vector<EnsembleRun> runs(const RunDescription& description, const std::vector<ParameterRange>& ranges,
                                  const TimeOptions& time) const;

private:
    std::string count_;
    std::vector<std::string> ranges_;
};

}  // namespace steplab
