#pragma once

#include "sim/ensemble/parameter_range.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// Runs that go beside a run and differ from it in one number, as a person asks for them.
struct LiveEnsembleOptions {
    static constexpr double usual_width = 1e-6, most_width = 0.5;

    std::size_t runs = 0;        ///< 0: no ensemble
    std::string spread = {};     ///< what differs: one of perturbable(); any other: the first of them
    double width = usual_width;  ///< by how much at most, over the run's own value
    /// They differ in something that the window cannot choose, as the command line can: in `ranges`.
    bool otherwise = false;
    std::vector<ParameterRange> ranges = {};  ///< used if `otherwise`, empty if not
    friend bool operator==(const LiveEnsembleOptions&, const LiveEnsembleOptions&) = default;
};

/// What the runs of an ensemble can differ in: the real parameters of the scene that are not 0, the speed at the start
/// first, and dt.
std::vector<std::string_view> perturbable(const RunDescription& description);

/// The options that give these runs: one number of the scene, or dt, varied about the run's own value with the shortest
/// width that gives the ends of its range exactly, or the nearest; otherwise `otherwise` is set.
LiveEnsembleOptions nearest_live_ensemble(const RunDescription& description, std::size_t runs,
                                          const std::vector<ParameterRange>& ranges);
/// What the runs of an ensemble beside a run of this description differ in.
std::vector<ParameterRange> ranges_of(const LiveEnsembleOptions& ensemble, const RunDescription& description);

/// From value (1 - width) to value (1 + width).
ParameterRange range_of(const LiveEnsembleOptions& ensemble, const RunDescription& description);

/// How far the runs of an ensemble are from the run they go beside.
struct EnsembleSpread {
    std::uint64_t step = 0;       ///< where they stand; the rest holds once that is where the run stands
    std::size_t lost = 0;         ///< runs with numbers that are not finite, which are left out
    double largest = 0;           ///< distance of a particle from where it is in the run
    double root_mean_square = 0;  ///< the same over all particles of all runs
    friend bool operator==(const EnsembleSpread&, const EnsembleSpread&) = default;
};

}  // namespace steplab
