#pragma once

#include "core/field.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace steplab {

/// Where a scene is at one time, as exactly as is known.
struct ReferenceMoment {
    double time = 0;
    State<double> state;  ///< displacements from the reference positions, and velocities
    double error = 0;     ///< how far from the truth a particle may be, by the reference's own estimate
};

/// What a run is judged by.
struct Reference {
    std::vector<ReferenceMoment> moments;  ///< at the asked times
    std::string how;                       ///< in words: exact, or which method in which steps
    bool exact = false;
};

/// How much a reference run may cost, and how good it is to be.
struct ReferenceEffort {
    double error = 1e-16;  ///< refined until the estimate is below; in units of the scene's spacing
    double most_particle_evaluations = 2e7;
    double first_phase = 2;  ///< omega_max times the step of the coarsest run
    int most_refinements = 12;
    /// Called on the way with the number of the run, from 1 on, and the part of it that is done; may throw to end it.
    std::function<void(int run, double part)> progress = nullptr;
};

/// The motion of the described scene, in its precision's parameters, at these ascending times from 0 on. Exact where a
/// closed form holds until the last of them. Elsewhere a run in long double by extrapolation of order 16, whose family
/// no method of the catalogue is of, refined by halving its steps; the difference to the run before is the error
/// estimate. Where particles pass each other the steps are chosen by the errors, collisions located and crossed as
/// methods/engines/collisions.hpp does it, and the tolerance refined. The description's method and dt do not matter.
/// Throws UsageError, Interrupted.
Reference reference(const RunDescription& description, std::span<const double> times,
                    const ReferenceEffort& effort = {});

/// The same by a run, even where a closed form is known: each checks the other.
Reference reference_run(const RunDescription& description, std::span<const double> times,
                        const ReferenceEffort& effort = {});

/// Where the scene comes to rest, exact for times so long that drag has damped everything; time is infinite. None where
/// it does not come to rest or nobody knows where.
std::optional<ReferenceMoment> resting_reference(const RunDescription& description);

/// Largest distance of a particle from the reference, and never less than the reference's own error.
double error_against(const ReferenceMoment& reference, const Field<double>& displacement);
/// Root of the mean square of the distances, and never less than the reference's own error.
double rms_error_against(const ReferenceMoment& reference, const Field<double>& displacement);

}  // namespace steplab
