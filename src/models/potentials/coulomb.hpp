#pragma once

#include "models/potentials/softened.hpp"

#include <array>
#include <span>

namespace steplab {

/// V = K q1 q2 / sqrt(r^2 + softening^2).
template <class T>
class Coulomb : public SoftenedInverse<T> {
    static constexpr std::array<PotentialInfo::Parameter, 2> parameters{{{"K"}, {"softening", false}}};

public:
    static constexpr PotentialInfo info{
        .name = "coulomb", .parameters = parameters, .weight = PotentialInfo::Weight::charges};

    explicit Coulomb(std::span<const double> values) : SoftenedInverse<T>(values[0], values[1]) {}
};

}  // namespace steplab
