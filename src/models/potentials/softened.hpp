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
        const N softened2 = at.squared + N(softening2_);
        return N(strength_) / (softened2 * square_root(softened2));
    }

private:
    T strength_, softening2_;
};

}  // namespace steplab
