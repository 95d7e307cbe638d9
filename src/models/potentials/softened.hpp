#pragma once

#include "models/potentials/potential.hpp"

#include <span>

namespace steplab {

/// V = K / sqrt(r^2 + softening^2); the strength K and the softening are the parameters, in this order.
template <class T>
class SoftenedInverse {
public:
    SoftenedInverse(double strength, double softening)
        : strength_(static_cast<T>(strength)), softening2_(static_cast<T>(softening) * static_cast<T>(softening)) {}

    template <class N>
    N energy(const PairDistance<N>& at) const {
        return N(strength_) / square_root(at.squared + N(softening2_));
    }
    template <class N>
    N factor(const PairDistance<N>& at) const {
        return factor(at, N(T(1)));
    }
    /// Times the product of masses or charges, with which the third power of the distance is outweighed.
    template <class N>
    N factor(const PairDistance<N>& at, const N& weight) const {
        const N strength = N(strength_) * weight;
        const N softened2 = at.squared + N(softening2_);
        if constexpr (is_series<N>) {
            return strength / (softened2 * square_root(softened2));  // each product of series costs much
        } else {
            // the third power of a distance in metres is soon more than float holds
            const N inverse = N(T(1)) / square_root(softened2);
            return ((strength * inverse) * inverse) * inverse;
        }
    }

    /// Whether the force changes its direction by a jump where two particles meet.
    bool jumps_at_contact() const { return !(softening2_ > T(0)); }

private:
    template <class N>
    static constexpr bool is_series = requires(const N& number) {
        number.coefficient();
    };

    T strength_, softening2_;
};

}  // namespace steplab
