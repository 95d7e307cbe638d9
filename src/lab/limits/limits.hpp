#pragma once

#include "sim/catalogue.hpp"
#include "sim/run/linearised.hpp"
#include "sim/run/run_description.hpp"

#include <optional>
#include <string>

namespace steplab {

/// The stability limit of a method on a scene, by linear theory and as measured by runs. Time steps; 0: unstable at any
/// dt, infinity: stable at any dt.
struct Limit {
    RunDescription description;      ///< the scene and method
    double omega_max = 0;            ///< largest angular frequency of the scene linearised at its start
    std::optional<double> theory;    ///< nullopt: not available, and the note says why
    std::optional<double> measured;  ///< nullopt: not measured, and the note says why
    std::string note;                ///< empty if there is no remark

    /// measured / theory, if both are finite and theory is not 0.
    std::optional<double> ratio() const;
};

/// Whether limits that theory says to be none are measured, which takes long: such methods solve equations.
enum class NoLimit { measured, by_theory };

/// Finds the limits of methods on one scene.
class StabilityLab {
public:
    /// The description's scene in its precision; its method is ignored. Throws UsageError (check()), also for scenes
    /// whose frequencies are above largest_frequency.
    explicit StabilityLab(const RunDescription& description, NoLimit no_limit = NoLimit::measured);

    double omega_max() const;
    /// The limit of the method named by the description; its scene must be that of this object. Theory: the smallest dt
    /// at which the matrix of a step on (x, v) has an eigenvalue larger than 1, over the frequencies of the scene, drag
    /// included. Measured: bisection to 3e-5 on runs of up to 8192 steps that begin with a small vibration in the mode
    /// that grows first by theory. Throws Interrupted.
    Limit limit(const RunDescription& description) const;

private:
    /// A frequency of the scene, its mode, and the limit of a method for it.
    struct Oscillation {
        double omega = 0;
        double gamma = 0;    ///< rate at which it is damped
        bool mixes = false;  ///< damping leads out of it: dashpots or drag are not spread as springs and masses are
        Eigen::Index mode = 0;
        double limit = infinity;
    };
    std::vector<Oscillation> oscillations() const;
    void find_damping(Oscillation& oscillation) const;
    Oscillation first_to_grow(const Method& method, const ParameterValues& parameters) const;
    /// The rate of the fastest non-oscillating departure from the initial positions.
    double departure() const;
    std::string why_not_measured(const RunDescription& held) const;
    void find(Limit& limit, const Method& method) const;

    NoLimit no_limit_;
    Plan scene_;  ///< balanced
    SceneFacts facts_;
    double spacing_;
    LinearisedScene linearised_;
    Eigenpairs modes_;
};

}  // namespace steplab
