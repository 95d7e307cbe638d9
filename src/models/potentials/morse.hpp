#pragma once

#include "models/potentials/potential.hpp"

#include <array>
#include <span>

namespace steplab {

/// V = D ((1 - exp(-b (r - r0)))^2 - 1), b = sqrt(k / (2 D)): a minimum of depth D and force constant k at r0.
template <class T>
class MorsePotential {
    static constexpr std::array<PotentialInfo::Parameter, 3> parameters{{{"D", true, true}, {"k", true, true}, {"r0"}}};

public:
    static constexpr PotentialInfo info{.name = "morse", .parameters = parameters};

    explicit MorsePotential(std::span<const double> values)
        : depth_(static_cast<T>(values[0])),
          b_(square_root(static_cast<T>(values[1]) / (T(2) * depth_))),
          r0_(static_cast<T>(values[2])) {}

    template <class N>
    N energy(const PairDistance<N>& at) const {
        const N e = exponential(N(b_) * (N(r0_) - at.length()));
        return N(depth_) * e * (e - N(T(2)));
    }
    template <class N>
    N factor(const PairDistance<N>& at) const {
        const N e = exponential(N(b_) * (N(r0_) - at.length()));
        return N(T(2) * b_ * depth_) * e * (e - N(T(1))) * at.inverse();
    }

private:
    T depth_, b_, r0_;
};

}  // namespace steplab
