#pragma once

#include "lab/limits/present_limit.hpp"
#include "lab/limits/replayed_run.hpp"
#include "sim/ensemble/live_ensemble.hpp"
#include "sim/run/simulation.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace steplab {

/// Another dt or method for a run that diverged, after a trial.
struct TriedRemedy {
    RunDescription run;
    double from = 0, until = 0;  ///< times between which it was tried [s]
    bool works = false;          ///< it did not diverge, and its energy error stayed below a tenth of the energy
    /// Largest |E - E0| of the trial over the energy at its start; none with drag or if it diverged.
    std::optional<double> energy_error = {};
    double cost = 0;  ///< its force evaluations per simulated second over those of the run that diverged
};

/// Why a run diverged.
struct BlowUp {
    Divergence divergence;
    RunDescription run;      ///< as it was when it diverged
    std::uint64_t step = 0;  ///< the last one before the energy left the range of its start
    double time = 0;         ///< of that step [s]
    /// Factor of the excess of energy from one step to the next after that, until it is as large as the energy; none
    /// where these are fewer than four.
    std::optional<double> growth = {};
    PresentLimit start;  ///< at the start of the run
    PresentLimit limit;  ///< at the moment since then at which a step is longest for the scene
    double share = 0;    ///< of that oscillation in the kinetic energy at the last valid step
    std::string why;     ///< one paragraph
    std::vector<TriedRemedy> tried = {};
    bool complete = false;  ///< all that were to be tried have been
};

/// Finds out why a run diverged, and what helps, by running it again. The same run gives the same answers.
class BlowUpStudy {
public:
    /// A run with what was done to it, the first being its start; it diverged so, at a step of its own. With moments
    /// that were `kept` of it, only what lies behind the last one at which all was well is computed again, some times.
    BlowUpStudy(std::span<const SegmentBegin> changes, const Divergence& divergence,
                std::vector<ReplayedRun::Moment> kept = {});
    ~BlowUpStudy();
    BlowUpStudy(BlowUpStudy&&) noexcept;
    BlowUpStudy& operator=(BlowUpStudy&&) noexcept;

    /// Finds the cause, and with each further call tries a remedy. False once everything is known. Throws UsageError,
    /// Interrupted.
    bool next();
    const BlowUp& found() const;
    /// How many steps it has taken, without those of remedies.
    std::uint64_t steps() const;

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

/// The paragraph `why`, from the rest.
std::string explanation_of(const BlowUp& blow_up);

}  // namespace steplab
