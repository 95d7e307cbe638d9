#include "app/cli/ensemble_options.hpp"

#include "app/cli/command_line.hpp"
#include "core/error.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

namespace steplab {

namespace {

constexpr ParameterInfo count_info{.name = "--ensemble",
                                   .kind = ParameterInfo::Kind::integer,
                                   .unit = "",
                                   .minimum = 1,
                                   .maximum = 1000000,
                                   .what = "number of runs"};

}  // namespace

void EnsembleOptions::declare(CLI::App& app) {
    const std::string group = "Ensemble";
    text_option(app, "--ensemble", count_, "N", "Number of runs in the ensemble; see --spread", group);
    repeated_option(app, "--spread", ranges_, "name=a:b",
                    "Vary a parameter or dt from a to b: a + (b - a) i/(N - 1) in run i = 0 ... N - 1; repeatable",
                    group);
}

bool EnsembleOptions::is_given() const {
    if (count_.empty() && !ranges_.empty())
        throw UsageError("--spread varies a parameter over the runs of an ensemble, but there is no --ensemble N");
    return !count_.empty();
}

std::size_t EnsembleOptions::count() const { return static_cast<std::size_t>(parse_value(count_info, count_)); }

std::vector<ParameterRange> EnsembleOptions::ranges(const RunDescription& description) const {
    std::vector<ParameterRange> ranges;
    for (const std::string& text : ranges_) {
        ranges.push_back(parse_parameter_range(description, text));
        for (std::size_t i = 0; i + 1 < ranges.size(); ++i) {
            if (ranges[i].name == ranges.back().name)
                throw UsageError(fmt::format("--spread names '{}' more than once", shown(ranges[i].name)));
        }
    }
    return ranges;
}

std::vector<EnsembleRun> EnsembleOptions::runs(const RunDescription& description,
                                               const std::vector<ParameterRange>& ranges,
                                               const TimeOptions& time) const {
    std::vector<EnsembleRun> runs;
    for (std::size_t i = 0; i < count(); ++i) {
        RunDescription run = run_in_range(description, ranges, i, count());
        const RunEnd end = time.end(run);
        runs.push_back({std::move(run), end});
    }
    return runs;
}

}  // namespace steplab
