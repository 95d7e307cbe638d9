#pragma once

#include "sim/ensemble/live_ensemble.hpp"
#include "sim/run/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace steplab {

/// A run gone through again, with all that was done to it at the steps where it was done.
class ReplayedRun {
public:
    /// The first of the changes is the start. Throws UsageError.
    explicit ReplayedRun(std::span<const SegmentBegin> changes);

    const Simulation& run() const { return run_; }
    /// Forward to this step, or to the last valid one. Throws Interrupted.
    void advance_to(std::uint64_t step);

    /// A moment to come back to.
    struct Moment {
        Simulation::Snapshot snapshot;
        std::size_t taken = 0;  ///< changes up to then
    };
    Moment moment() const { return {run_.save(), taken_}; }
    void go_back_to(const Moment& moment);

private:
    Simulation run_;
    std::vector<SegmentBegin> changes_;
    std::size_t taken_ = 1;
};

}  // namespace steplab
