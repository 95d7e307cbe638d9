#pragma once

#include "app/cli/progress.hpp"
#include "sim/run/simulation.hpp"

#include <cstdint>

namespace steplab {

/// Takes a simulation from stop to stop so that every stop is sure: a run that diverges afterwards has its last good
/// step there or later, so that no row need ever be taken back. Between checks of the energy it runs ahead to the next
/// one and comes back. Steps go in pieces of some hundredths of a second, between which it looks for signals and tells
/// the progress.
class Pacer {
public:
    /// `end`: the last step of the run, where its energy is judged whatever the grid of checks.
    explicit Pacer(std::uint64_t end) : end_(end) {}

    /// Up to `target` <= end, or to the last good step if the run diverges before. Throws Interrupted.
    void advance(Simulation& simulation, std::uint64_t target, Progress& progress);

private:
    void walk(Simulation& simulation, std::uint64_t target, Progress& progress);
    void make_sure(Simulation& simulation, std::uint64_t target, Progress& progress);

    std::uint64_t end_;
    std::uint64_t sure_until_ = 0;  ///< every step up to here is known to be good
    std::uint64_t piece_ = 1;
};

}  // namespace steplab
