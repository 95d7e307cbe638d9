#pragma once

#include "models/conservation.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/energy.hpp"
#include "sim/run/execution.hpp"
#include "sim/run/method_refusals.hpp"
#include "sim/run/particle_forces.hpp"
#include "sim/run/resolution.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace steplab {

/// How a method begins a segment of `held` (as_held()) on its scene, at the scene's own start. The scene is referred
/// to.
inline StepperSetup segment_start(const RunDescription& held, const Plan& scene, Instructions instructions) {
    return {scene, scene.start, held.method_parameters, held.precision, held.dt, instructions};
}

/// A stretch of a run in which nothing changes: one description, the scene it makes, the method at work on it.
struct Segment {
    RunDescription description;  ///< as given
    RunDescription held;         ///< with dt and parameters as the precision holds them
    Execution execution;
    Plan scene;  ///< its start is that of the segment
    EnergyMeter meter;
    std::uint64_t steps_at_once;  ///< that take no longer than some tenths of a second, or one
    std::unique_ptr<Stepper> stepper;

    /// Begins at the scene's own start. Throws UsageError if the description cannot be run.
    explicit Segment(const RunDescription& description, const Execution& execution = {});
    /// Begins at a synchronised state; with `dt`, its steps are of that length instead of the description's.
    Segment(const RunDescription& description, const Execution& execution, const Start& start,
            std::optional<double> dt = {});

    /// Puts the stepper back to where the segment began.
    void restart();
    /// Begins again at another synchronised state: the same as a new segment of this description.
    void begin_at(Start start);

    // Of the held description; each computed when it is first asked for.
    const std::optional<StabilityLimit>& limit() const;
    /// Of the fastest oscillation, if its frequency is known.
    const std::optional<Resolution>& resolution() const;
    const Conservation& conservation() const;
    const std::shared_ptr<const MethodRefusals>& refusals() const;
    ParticleForces& forces() const;

private:
    mutable std::optional<Conservation> conservation_;
    mutable std::shared_ptr<const MethodRefusals> refusals_;
    mutable std::optional<ParticleForces> forces_;
    mutable std::optional<std::optional<StabilityLimit>> limit_;
    mutable std::optional<std::optional<Resolution>> resolution_;
};

}  // namespace steplab
