#pragma once

#include "core/field.hpp"
#include "core/shape.hpp"
#include "core/vec3.hpp"
#include "lab/study/reference.hpp"
#include "sim/run/simulation.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace steplab {

/// A run at one of its steps, as it is compared with the motion that it approximates.
struct RunMoment {
    std::uint64_t step = 0;
    double time = 0;
    Field<double> displacement;
    std::shared_ptr<const Shape> shape;
    /// E - E0, the work of drag counted in; none where drag takes energy and its work is not counted.
    std::optional<double> energy_error;
    /// |P - P0|; none where the scene does not keep momentum, or it was changed under way.
    std::optional<double> momentum_error;
    std::uint64_t evaluations = 0;  ///< since the start
};

/// As in RunMoment.
std::optional<double> energy_error_of(const Simulation& run);

/// `start`: the momentum with which the run began.
RunMoment moment_of(const Simulation& run, Vec3 start);

/// A run beside the motion that it approximates, at one time.
struct Compared {
    std::uint64_t step = 0;  ///< at which it stands
    double time = 0;         ///< of that step
    double error = 0;        ///< largest distance of a particle from the reference at that time
    double rms_error = 0;    ///< root of the mean squared distance of moving particles
    std::optional<double> energy_error, momentum_error;
    /// The time [s] by which the run is ahead of the motion, as far as its distance from it lies along the motion's
    /// velocities: <d, v> / <v, v> over all particles. None where nothing moves.
    std::optional<double> phase_error = {};
    double reference_error = 0;  ///< estimated; 0 of an exact solution
    std::uint64_t evaluations = 0;
};

/// `reference` is that of the moment's time.
Compared compared(const RunMoment& run, const ReferenceMoment& reference, bool exact);

/// The step at which a run of this dt is shown at a time: the last one that does not lie after it. A step within
/// 1e-6 dt counts as being there.
std::uint64_t step_at(double time, double dt);

}  // namespace steplab
