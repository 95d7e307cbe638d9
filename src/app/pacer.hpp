#pragma once

#include "app/progress.hpp"
#include "sim/simulation.hpp"

#include <cstdint>

namespace steplab {

/// Steps in pieces of some milliseconds, so that neither a signal nor the progress bar waits for a long stretch.
class Pacer {
public:
    /// Goes on to step `target`, or to where the run diverges. Throws Interrupted.
    void advance(Simulation& simulation, std::uint64_t target, Progress& progress);

private:
    std::uint64_t piece_ = 1;
};

}  // namespace steplab
