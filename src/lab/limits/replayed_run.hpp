#pragma once

#include "sim/ensemble/live_ensemble.hpp"
#include "sim/run/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace steplab {

/// A run gone through again, with all that was done to it at the steps where it was done. It comes back to moments that
/// were kept when it ran; where there are none, to some that it keeps on its first long way.
class ReplayedRun {
public:
    /// A moment to come back to.
    struct Moment {
        Simulation::Snapshot snapshot;
        std::size_t taken = 0;  ///< changes up to then, the start counted
    };

    /// The first of the changes is the start. `kept`: moments of that run, in the order of their steps. Throws
    /// UsageError.
    explicit ReplayedRun(std::span<const SegmentBegin> changes, std::vector<Moment> kept = {});

    const Simulation& run() const { return run_; }
    /// Steps that it has taken in all.
    std::uint64_t steps() const { return steps_; }
    /// Forward to this step, or to the last valid one. Throws Interrupted.
    void advance_to(std::uint64_t step);
    /// The same, back as well, from the nearest moment that is kept.
    void go_to(std::uint64_t step);

    Moment moment() const { return {run_.save(), taken_}; }
    void go_back_to(const Moment& moment);
    /// Back to the last moment kept, up to this step, of which `good()` says true when the run stands there; otherwise
    /// to the start.
    template <class Good>
    void go_back_to_last(std::uint64_t step, const Good& good) {
        for (std::size_t i = kept_.size(); i-- > 0;) {
            if (kept_[i].snapshot.step() > step) continue;
            go_back_to(kept_[i]);
            if (good()) return;
        }
        go_back_to(kept_.front());
    }

private:
    void advance_by(std::uint64_t steps);

    Simulation run_;
    std::vector<SegmentBegin> changes_;
    std::size_t taken_ = 1;
    std::uint64_t steps_ = 0;
    std::vector<Moment> kept_;  ///< the start first
};

}  // namespace steplab
