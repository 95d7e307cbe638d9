#pragma once

#include "models/potentials/softened.hpp"

#include <array>
#include <span>

namespace steplab {

/// V = -G m1 m2 / sqrt(r^2 + softening^2).
template <class T>
class Gravity : public SoftenedInverse<T> {
    static constexpr std::array<PotentialInfo::Parameter, 2> parameters{{{"G"}, {"softening", false}}};

public:
    static constexpr PotentialInfo info{
        .name = "gravity", .parameters = parameters, .weight = PotentialInfo::Weight::masses};

    explicit Gravity(std::span<const double> values) : SoftenedInverse<T>(-values[0], values[1]) {}
};

}  // namespace steplab
