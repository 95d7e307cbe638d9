#pragma once

#include "core/field.hpp"
#include "methods/engines/step_parts.hpp"
#include "models/forces/plain.hpp"
#include "models/plan.hpp"

#include <cstddef>

namespace steplab {

/// The work that drag does, c times the integral of v^2 over all particles, as a method integrates it: by the weights
/// of its stages, or in closed form over each of its kicks. The energy and this work together are as accurate as the
/// method. The step is computed again, in double and apart from the run, of which no bit depends on it.
class DragWork {
public:
    /// `scene` as the run's precision holds it. `parts` must be known.
    DragWork(const Plan& scene, const StepParts& parts, double dt);

    /// In J, of the step that begins at `state`.
    double of_step(const State<double>& state);

private:
    void accelerate();
    double kick(double time);
    void drift(double time);
    double stages();

    double mass_, drag_;
    StepParts parts_;
    double dt_;
    Plain<double> forces_;
    Field<double> reference_;           ///< positions
    State<double> from_, at_;           ///< beginning of the step; a moment within it
    Field<double> positions_, slopes_;  ///< absolute; accelerations
};

}  // namespace steplab
