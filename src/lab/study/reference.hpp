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

/// The state of a scene at one time, as accurate as known.
struct ReferenceMoment {
    double time = 0;
    State<double> state;  ///< displacements from the reference positions, and velocities
    double error = 0;     ///< largest error of a particle's position, estimated
};

/// A reference solution, with which runs are compared.
struct Reference {
    std::vector<ReferenceMoment> moments;  ///< at the requested times
    std::string how;                       ///< in words: exact, or by which method and steps
    bool exact = false;
};

/// The accuracy and the largest cost of a reference run.
struct ReferenceEffort {
    double error = 1e-16;  ///< refined until the estimated error is below, in units of the scene's spacing
    double most_particle_evaluations = 2e7;
    double first_phase = 2;  ///< omega_max times the step of the coarsest run
    int most_refinements = 12;
    double least_gain = 0;  ///< a refinement that makes the error less than so many times smaller is the last one
    /// Called every few steps with the number of the run, from 1, and the fraction of it that is done; may throw to end
    /// it.
    std::function<void(int run, double part)> progress = nullptr;
};

/// The motion of the described scene, with parameters in its precision, at these ascending times >= 0. Exact if a
/// closed form is valid until the last of them. Otherwise a run in long double by extrapolation of order 16, a family
/// to which no method of the catalogue belongs, refined by halving its steps; the difference from the previous run is
/// the error estimate. If particles pass each other, the steps are adaptive, collisions are located and crossed
/// (methods/engines/collisions.hpp), and the tolerance is refined. The method and dt of the description are ignored.
/// Throws UsageError, Interrupted.
Reference reference(const RunDescription& description, std::span<const double> times,
                    const ReferenceEffort& effort = {});

/// The same if a closed form is valid until the last of the times; else none.
std::optional<Reference> exact_reference(const RunDescription& description, std::span<const double> times);

/// The same by a run, even if a closed form is known: each checks the other.
Reference reference_run(const RunDescription& description, std::span<const double> times,
                        const ReferenceEffort& effort = {});

/// The equilibrium of the scene, exact for times at which drag has damped all motion; its time is infinite. nullopt if
/// the scene does not come to rest, or the equilibrium is not known.
std::optional<ReferenceMoment> resting_reference(const RunDescription& description);

/// The closed form at a time, of so many particles.
ReferenceMoment exact_moment(const ExactSolution& exact, std::size_t particles, double time);

/// Largest distance of a particle from the reference, and never less than the reference's own error.
double error_against(const ReferenceMoment& reference, const Field<double>& displacement);
/// Root of the mean square of the distances, and never less than the reference's own error.
double rms_error_against(const ReferenceMoment& reference, const Field<double>& displacement);

}  // namespace steplab
