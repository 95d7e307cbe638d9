#pragma once

#include "sim/ensemble/live_ensemble.hpp"
#include "sim/ensemble/parameter_range.hpp"
#include "sim/run/run_view.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace steplab {

/// The cloud that the window would be asked for to have this ensemble: one number of the scene, or dt, over the run's
/// own value. `otherwise` if it cannot be asked for it.
Cloud nearest_cloud(const RunDescription& description, std::size_t runs, const std::vector<Spread>& spreads);

/// The cloud of an ensemble in a picture.
class SnapshotCloud {
public:
    /// Throws UsageError if there cannot be such a cloud, Interrupted.
    SnapshotCloud(const RunDescription& description, std::size_t runs, const std::vector<Spread>& spreads);

    /// Computes it for this moment of a run in which nothing was changed. Throws Interrupted.
    void put_into(RunView& view);

private:
    void go_to(std::uint64_t step);

    std::vector<SegmentBegin> segments_;
    Cloud cloud_;
    Companions companions_;
};

}  // namespace steplab
