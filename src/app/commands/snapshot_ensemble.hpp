#pragma once

#include "sim/ensemble/live_ensemble.hpp"
#include "sim/ensemble/parameter_range.hpp"
#include "sim/run/run_view.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace steplab {

/// The ensemble that the window would be asked for to have this ensemble: one number of the scene, or dt, over the
/// run's own value. `otherwise` if it cannot be asked for it.
LiveEnsembleOptions nearest_live_ensemble(const RunDescription& description, std::size_t runs,
                                          const std::vector<ParameterRange>& ranges);

/// The ensemble of an ensemble in a picture.
class SnapshotEnsemble {
public:
    /// Throws UsageError if there cannot be such an ensemble, Interrupted.
    SnapshotEnsemble(const RunDescription& description, std::size_t runs, const std::vector<ParameterRange>& ranges);

    /// Computes it for this moment of a run in which nothing was changed. Throws Interrupted.
    void put_into(RunView& view);

private:
    void go_to(std::uint64_t step);

    std::vector<SegmentBegin> segments_;
    LiveEnsembleOptions ensemble_;
    LiveEnsemble live_ensemble_;
};

}  // namespace steplab
