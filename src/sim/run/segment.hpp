#pragma once

#include "sim/catalogue.hpp"
#include "sim/run/energy.hpp"
#include "sim/run/execution.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace steplab {

/// How a method begins a segment of `held` (as_held()) on its scene, at the scene's own start. The scene is referred
/// to.
inline StepperSetup segment_start(const RunDescription& held, const Scene& scene, Instructions instructions) {
    return {scene, scene.start, held.method_parameters, held.precision, held.dt, instructions};
}

/// A stretch of a run in which nothing changes: one description, the scene it makes, the method at work on it.
struct Segment {
    RunDescription description;  ///< as given
    RunDescription held;         ///< with dt and parameters as the precision holds them
    Execution execution;
    Scene scene;  ///< its start is that of the segment
    EnergyMeter meter;
    std::uint64_t steps_at_once;  ///< that take no longer than some tenths of a second, or one
    std::unique_ptr<Stepper> stepper;

    /// Begins at the scene's own start. Throws UsageError if the description cannot be run.
    explicit Segment(const RunDescription& description, const Execution& execution = {});
    /// Begins at a synchronised state.
    Segment(const RunDescription& description, const Execution& execution, const Start& start);

    /// Puts the stepper back to where the segment began.
    void restart();

    /// stability_limit() of the held description; computed when first asked for.
    const std::optional<StabilityLimit>& limit() const;

private:
    mutable bool limit_known_ = false;
    mutable std::optional<StabilityLimit> limit_;
};

}  // namespace steplab
