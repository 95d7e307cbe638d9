#pragma once

#include "core/field.hpp"
#include "methods/engines/step_parts.hpp"
#include "models/plan.hpp"

#include <functional>
#include <vector>

namespace steplab {

/// c of each particle [kg/s].
std::vector<double> drag_coefficients(const Plan& scene);

/// The work that drag does, c times the integral of v^2 over all particles, as a method integrates it: by the weights
/// of its stages, or in closed form over each of its kicks. The energy and this work together are as accurate as the
/// method. The step is computed again, in double and apart from the run, of which no bit depends on it. For methods
/// that do not count it themselves (CountedDrag).
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

    double product(const Field<double>& p, const Field<double>& q) const;

    std::vector<double> coefficients_;
    double drag_;  ///< rate
    StepParts parts_;
    double dt_;
    std::function<void(const Field<double>& x, Field<double>& a)> force_;
    State<double> from_, at_;  ///< beginning of the step; a moment within it
    Field<double> slopes_;     ///< accelerations
};

}  // namespace steplab
