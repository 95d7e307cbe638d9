#pragma once

#include "core/shape.hpp"
#include "core/vec3.hpp"
#include "lab/study/reference.hpp"
#include "sim/run/simulation.hpp"

#include <cstdint>
#include <optional>

namespace steplab {

/// A run beside the motion that it approximates, at one time.
struct Compared {
    std::uint64_t step = 0;  ///< at which it stands
    double time = 0;         ///< of that step
    double error = 0;        ///< largest distance of a particle from the reference at that time
    double rms_error = 0;    ///< root of the mean squared distance of moving particles
    /// E - E0, the work of drag counted in; none where drag takes energy and its work is not counted.
    std::optional<double> energy_error;
    std::optional<double> momentum_error;  ///< |P - P0|; none where the scene does not keep momentum
    double reference_error = 0;            ///< estimated; 0 of an exact solution
    std::uint64_t evaluations = 0;         ///< since the start
};

/// The step at which a run of this dt is shown at a time: the last one that does not lie after it. A step within
/// 1e-6 dt counts as being there.
std::uint64_t step_at(double time, double dt);

/// Compares runs with the momentum that they started with.
class RunErrors {
public:
    /// `run` at its start.
    explicit RunErrors(const Simulation& run);
    /// `reference` is that of the time at which the run stands.
    Compared of(const Simulation& run, const ReferenceMoment& reference, bool exact) const;

private:
    Vec3 momentum_;  ///< at the start
};

}  // namespace steplab
