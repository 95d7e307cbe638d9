#pragma once

#include "lab/limits/limit_search.hpp"
#include "sim/catalogue.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace steplab {

/// The scene with accelerations a(x0 + u) - a(x0), x0 being its start: the same forces with an equilibrium at x0.
Plan balanced(Plan scene);

/// Small vibrations of a balanced scene about its start in one mode, stepped by a method, and their growth.
class ModeRun {
public:
    /// `scene` must outlive this object; `shape` is the mode, `omega` its angular frequency, `size` the largest
    /// displacement of the vibration, `departure` the rate of the scene's unstable departure from its start.
    ModeRun(const Method& method, const ParameterValues& parameters, Precision precision, const Plan& scene,
            const Field<double>& shape, double omega, double size, double departure);

    /// The characteristic time of the mode: 1 / max(omega, gamma).
    double time_scale() const { return 1 / rate_; }
    /// Whether the vibration grows: by a factor of 100 at any time, or to a size in the last quarter of the run whose
    /// logarithm exceeds that in an earlier quarter by more than `allowed`, the variation of a bounded one; the first
    /// eighth is ignored, because transients decay in it. Every few steps all components outside the mode (rounding
    /// amplified by other modes) are removed and the vibration is scaled back to its initial size, so that the run
    /// stays in the linear range for any duration.
    bool grows(const GrowthQuestion& question) const;
    /// Number of such runs in SIMD lanes, each bit-identical to the run alone.
    std::size_t most_at_once() const;
    /// Answers the first question, and those of the others whose runs fit into lanes with it.
    void answer(std::span<GrowthQuestion> questions) const;
    /// The relative deviation of the force from linearity for a vibration of this size: |a(x0 + u) - a(x0) + omega^2 u|
    /// / (omega^2 |u|).
    double nonlinearity() const;

private:
    struct Motion;
    class Course;

    /// Steps between two rescalings.
    std::uint64_t block(double dt) const;
    State<double> state(const Motion& motion) const;
    StepperSetup setup(State<double> start, double dt) const;
    /// Null if runs with these dt cannot be combined in lanes; otherwise with at least one run.
    std::unique_ptr<EnsembleStepper> group(std::span<const GrowthQuestion> questions) const;
    void take(Course& course) const;
    void take(std::span<Course> courses, EnsembleStepper& group) const;

    const Method& method_;
    ParameterValues parameters_;
    Precision precision_;
    const Plan& scene_;
    Field<double> start_;  ///< initial displacements of the scene
    Field<double> shape_;  ///< its largest displacement is `size`
    /// The shape times the masses: other modes are at right angles to it.
    Field<double> weighted_;
    double norm_ = 0;
    double omega_, rate_, departure_;
};

}  // namespace steplab
