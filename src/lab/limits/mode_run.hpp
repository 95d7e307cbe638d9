#pragma once

#include "lab/limits/limit_search.hpp"
#include "sim/catalogue.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace steplab {

/// The scene whose accelerations are a(x0 + u) - a(x0), x0 being its start: so that it rests there, on the same forces.
Scene balanced(Scene scene);

/// A method at work on small vibrations of a balanced scene about its start in one mode: what it does to their size.
class ModeRun {
public:
    /// `scene` must outlive this object; `shape` is the mode, `omega` its angular frequency, `size` the largest
    /// displacement that the vibration has, `departure` the rate at which the scene departs from its start by itself.
    ModeRun(const Method& method, const ParameterValues& parameters, Precision precision, const Scene& scene,
            const Field<double>& shape, double omega, double size, double departure);

    /// The time in which the mode does something: 1 / max(omega, gamma).
    double time_scale() const { return 1 / rate_; }
    /// Whether the vibration grows: a hundredfold at some time, or to a size in the last quarter of the run whose
    /// logarithm exceeds that in an earlier quarter by more than `allowed`, the ups and downs of a bounded one; the
    /// first eighth is left for what dies out. Every few steps all that is not of the mode (what other modes made of
    /// rounding) is dropped and the vibration made as small as it was, so that the run stays in the linear range
    /// however long it is.
    bool grows(const GrowthQuestion& question) const;
    /// How many of such runs go side by side, each with the bits that it has alone.
    std::size_t most_at_once() const;
    /// Answers the first question, and those of the others whose runs can go beside it.
    void answer(std::span<GrowthQuestion> questions) const;
    /// How far the force is from linear for a vibration of this size: |a(x0 + u) - a(x0) + omega^2 u| / (omega^2 |u|).
    double nonlinearity() const;

private:
    struct Motion;
    class Course;

    /// Steps from one shrinking to the next.
    std::uint64_t block(double dt) const;
    State<double> state(const Motion& motion) const;
    StepperSetup setup(State<double> start, double dt) const;
    /// Null if runs of these dt do not go side by side; else with one run at least.
    std::unique_ptr<EnsembleStepper> group(std::span<const GrowthQuestion> questions) const;
    void take(Course& course) const;
    void take(std::span<Course> courses, EnsembleStepper& group) const;

    const Method& method_;
    ParameterValues parameters_;
    Precision precision_;
    const Scene& scene_;
    Field<double> start_;  ///< displacements of the scene's start
    Field<double> shape_;  ///< largest displacement `size`
    double norm_ = 0;
    double omega_, rate_, departure_;
};

}  // namespace steplab
