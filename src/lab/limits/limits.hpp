#pragma once

#include "lab/limits/linearised.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/run_description.hpp"

#include <optional>
#include <string>

namespace steplab {

/// The stability limit of a method on a scene, as theory gives it and as runs show it. Time steps: 0 = unstable at any
/// dt, infinity = stable at any dt.
struct Limit {
    RunDescription description;      ///< what was asked about
    double omega_max = 0;            ///< largest angular frequency of the scene linearised at its start
    std::optional<double> theory;    ///< none: theory has no answer, and the note says why
    std::optional<double> measured;  ///< none: not measured, and the note says why
    std::string note;                ///< empty if there is nothing to say

    /// measured / theory, where both are numbers that have a ratio.
    std::optional<double> ratio() const;
};

/// Finds the limits of methods on one scene.
class StabilityLab {
public:
    /// The description's scene in its precision; the method does not matter. Throws UsageError (check()).
    explicit StabilityLab(const RunDescription& description);

    double omega_max() const;
    /// Of the method that the description names; its scene must be that of this object.
    /// Theory: the first dt at which the matrix that a step makes of (x, v) has an eigenvalue larger than 1, over the
    /// frequencies of the scene, drag included. Measured: bisection to 3e-5 on runs of up to 8192 steps that begin as a
    /// small vibration in the mode which theory says grows first. Throws Interrupted.
    Limit limit(const RunDescription& description) const;

private:
    /// A frequency of the scene, the mode that has it, and a method's limit there.
    struct Oscillation {
        double omega = 0;
        Eigen::Index mode = 0;
        double limit = infinity;
    };
    std::vector<Oscillation> oscillations() const;
    Oscillation first_to_grow(const Method& method, const ParameterValues& parameters) const;
    /// The rate of the fastest departure from the start that is no oscillation.
    double departure() const;
    void find(Limit& limit, const Method& method) const;

    Scene scene_;  ///< balanced
    double spacing_;
    LinearisedScene linearised_;
    Eigenpairs modes_;
};

}  // namespace steplab
