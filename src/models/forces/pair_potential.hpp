#pragma once

#include "core/number.hpp"
#include "core/power.hpp"
#include "core/vector.hpp"
#include "models/forces/composition.hpp"

#include <limits>

namespace steplab {

/// A pair potential V(r) of unit strength in number type T, shifted to zero at a cut-off c together with its slope:
/// V(r)
/// - V(c) - (r - c) V'(c). What is multiplied by it is the product of masses or charges (ComposedPairs).
template <class T>
class PairPotential {
public:
    using Kind = ComposedPairs::Potential;

    explicit PairPotential(const ComposedPairs& pairs)
        : kind_(pairs.potential),
          depth_(static_cast<T>(pairs.depth)),
          b_(square_root(static_cast<T>(pairs.k) / (T(2) * static_cast<T>(pairs.depth)))),
          r0_(static_cast<T>(pairs.r0)),
          epsilon_(static_cast<T>(pairs.epsilon)),
          sigma2_(static_cast<T>(pairs.sigma) * static_cast<T>(pairs.sigma)),
          strength_(static_cast<T>(pairs.potential == Kind::gravity ? -pairs.strength : pairs.strength)),
          softening2_(static_cast<T>(pairs.softening) * static_cast<T>(pairs.softening)),
          cut_(pairs.cutoff > 0) {
        if (!cut_) return;
        cutoff_ = static_cast<T>(pairs.cutoff);
        const T distance2 = cutoff_ * cutoff_;
        force_there_ = uncut_factor(distance2, cutoff_) * cutoff_;
        energy_there_ = uncut_energy(distance2, cutoff_);
    }

    bool cut() const { return cut_; }
    T cutoff() const { return cutoff_; }

    /// The force on a particle at distance vector d from another is this times d, |d|^2 = distance2 > 0 and below the
    /// cut-off. In any number type that is made of T.
    template <class N>
    N factor(const N& distance2) const {
        const N distance = square_root(distance2);
        const N uncut = uncut_factor(distance2, distance);
        return cut_ ? uncut - N(force_there_) / distance : uncut;
    }

    /// V at that distance.
    template <class N>
    N energy(const N& distance2) const {
        const N distance = square_root(distance2);
        const N uncut = uncut_energy(distance2, distance);
        return cut_ ? uncut - N(energy_there_) + (distance - N(cutoff_)) * N(force_there_) : uncut;
    }

    /// V at distance 0, if it is finite there; else 0.
    T energy_of_coincident() const {
        if (kind_ == Kind::lennard_jones || (kind_ != Kind::morse && softening2_ == T(0))) return T(0);
        return energy(T(0));
    }

private:
    template <class N>
    N uncut_factor(const N& distance2, const N& distance) const {
        switch (kind_) {
            case Kind::morse: {
                const N e = exponential(N(b_) * (N(r0_) - distance));
                return N(T(2) * b_ * depth_) * e * (e - N(T(1))) / distance;
            }
            case Kind::lennard_jones: {
                const N s2 = N(sigma2_) / distance2, s6 = s2 * s2 * s2;
                return N(T(24) * epsilon_) * s6 * (N(T(2)) * s6 - N(T(1))) / distance2;
            }
            default: {
                const N softened2 = distance2 + N(softening2_);
                return N(strength_) / (softened2 * square_root(softened2));
            }
        }
    }

    template <class N>
    N uncut_energy(const N& distance2, const N& distance) const {
        switch (kind_) {
            case Kind::morse: {
                const N e = exponential(N(b_) * (N(r0_) - distance));
                return N(depth_) * e * (e - N(T(2)));
            }
            case Kind::lennard_jones: {
                const N s2 = N(sigma2_) / distance2, s6 = s2 * s2 * s2;
                return N(T(4) * epsilon_) * s6 * (s6 - N(T(1)));
            }
            default:
                return N(strength_) / square_root(distance2 + N(softening2_));
        }
    }

    Kind kind_;
    T depth_, b_, r0_, epsilon_, sigma2_, strength_, softening2_;
    bool cut_;
    T cutoff_ = T(0), force_there_ = T(0), energy_there_ = T(0);
};

}  // namespace steplab
