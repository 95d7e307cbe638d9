#pragma once

#include "methods/engines/splitting.hpp"

namespace steplab {

/// The Euler method of the thesis: positions advance with the new velocity (semi-implicit, symplectic).
struct Euler {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "euler",
        .name = "Semi-implicit Euler",
        .what = "The simplest method with a bounded energy error: kick, then drift with the new velocity.",
        .order = 1,
        .order_with_drag = 1,
        .order_with_damping = 1,
        .evaluations = 1,
        .linear_limit = 2,
        .symplectic = true,
        .conserves = "momentum, angular momentum; bounded energy error",
        .source = "Hairer, Lubich, Wanner, Geometric Numerical Integration, I.1.2",
        .parameters = parameters,
    };

    static constexpr bool explicit_drag = true;
    static constexpr std::array<KickAndDrift, 1> table{{{.kick = 1, .drift = 1}}};

    template <class T>
    using Integrator = Splitting<T, Euler>;
};

}  // namespace steplab
