#pragma once

#include "lab/limits/blow_up.hpp"

namespace steplab {

/// Tries remedies of one run that diverged.
class RemedyTrial {
public:
    /// `last`: the run before its energy left the range of its start, where a trial begins that would take too long
    /// from the start. `until`: time of the divergence. `cost`: the run's force evaluations per simulated second.
    RemedyTrial(Simulation::Snapshot last, const RunDescription& run, double until, double cost);

    /// A quarter longer than the run lasted, as far as a second or so of computing allows. Throws UsageError,
    /// Interrupted.
    TriedRemedy of(const RunDescription& remedy) const;

private:
    Simulation::Snapshot last_;
    RunDescription run_;
    double until_, cost_;
};

}  // namespace steplab
