#pragma once

#include "sim/catalogue.hpp"

#include <cstdint>

namespace steplab {

/// The scene whose accelerations are a(x0 + u) - a(x0), x0 being its start: so that it rests there, on the same forces.
Scene balanced(Scene scene);

/// A method at work on small vibrations of a balanced scene about its start in one mode: what it does to their size.
class ModeRun {
public:
    /// `scene` must outlive this object; `shape` is the mode, `omega` its angular frequency, `size` the largest
    /// displacement that the vibration has.
    ModeRun(const Method& method, const ParameterValues& parameters, Precision precision, const Scene& scene,
            const Field<double>& shape, double omega, double size);

    /// The time in which the mode does something: 1 / max(omega, gamma).
    double time_scale() const { return 1 / rate_; }
    /// Natural logarithm of the factor by which the vibration grows in `steps` steps, in a run that ends early once it
    /// is above 7 or below -20; infinite if numbers were not finite. Every 32 steps all that is not of the mode
    /// (what other modes made of rounding) is dropped and the vibration made as small as it was, so that the run stays
    /// in the linear range however long it is.
    double growth(double dt, std::uint64_t steps) const;
    /// True if the vibration grows in 8192 steps by more than the ups and downs of a bounded one.
    bool grows_slowly(double dt) const;
    /// How far the force is from linear for a vibration of this size: |a(x0 + u) - a(x0) + omega^2 u| / (omega^2 |u|).
    double nonlinearity() const;

private:
    struct Motion;
    /// Of the factor of one block of steps.
    double log_factor(Motion& motion, double dt) const;

    const Method& method_;
    ParameterValues parameters_;
    Precision precision_;
    const Scene& scene_;
    Field<double> shape_;  ///< largest displacement `size`
    double omega_, rate_;
};

}  // namespace steplab
