#pragma once

#include "models/potentials/potential.hpp"

#include <array>
#include <span>

namespace steplab {

/// V = 4 epsilon ((sigma / r)^12 - (sigma / r)^6).
template <class T>
class LennardJones {
    static constexpr std::array<PotentialInfo::Parameter, 2> parameters{{{"epsilon"}, {"sigma", true, true}}};

public:
    static constexpr PotentialInfo info{.name = "lennard-jones", .parameters = parameters};

    explicit LennardJones(std::span<const double> values)
        : epsilon_(static_cast<T>(values[0])), sigma2_(static_cast<T>(values[1]) * static_cast<T>(values[1])) {}

    template <class N>
    N energy(const PairDistance<N>& at) const {
        const N s2 = N(sigma2_) / at.squared, s6 = s2 * s2 * s2;
        return N(T(4) * epsilon_) * s6 * (s6 - N(T(1)));
    }
    template <class N>
    N factor(const PairDistance<N>& at) const {
        const N inverse2 = at.inverse_squared(), s2 = N(sigma2_) * inverse2, s6 = s2 * s2 * s2;
        return N(T(24) * epsilon_) * s6 * (N(T(2)) * s6 - N(T(1))) * inverse2;
    }

private:
    T epsilon_, sigma2_;
};

}  // namespace steplab
