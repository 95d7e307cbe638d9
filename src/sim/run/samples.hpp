#pragma once

#include "sim/run/simulation.hpp"

#include <algorithm>
#include <cstdint>

namespace steplab {

/// The moments at which a run of `steps` steps is sampled: equally far apart as far as whole steps allow, the last one
/// its end, where the energy is judged too.
///
///     for (Samples samples(steps, 64); samples.advance(simulation);) ...
class Samples {
public:
    /// No more samples than steps.
    Samples(std::uint64_t steps, std::uint64_t count) : steps_(steps), count_(std::min(count, steps)) {}

    std::uint64_t count() const { return count_; }
    /// Number of the present sample, counted from 1.
    std::uint64_t number() const { return taken_; }

    /// On to the next sample; a run that diverges stands at its last good step there. False if there is no further one,
    /// or the run had diverged before.
    bool advance(Simulation& simulation) {
        if (taken_ == count_ || simulation.divergence()) return false;
        ++taken_;
        simulation.advance(steps_ * taken_ / count_ - simulation.step());
        if (taken_ == count_) simulation.conclude();
        return true;
    }

private:
    std::uint64_t steps_, count_, taken_ = 0;
};

}  // namespace steplab
