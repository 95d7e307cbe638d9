#pragma once

#include "methods/engines/runge_kutta.hpp"

namespace steplab {

/// The classic Runge-Kutta method.
struct Rk4 {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "rk4",
        .name = "Runge-Kutta 4",
        .what = "The classic method: accurate for its cost at small dt; slowly loses energy in long runs.",
        .order = 4,
        .order_with_drag = 4,
        .order_with_damping = 4,
        .evaluations = 4,
        .linear_limit = 2.8284271247461903,  // 2 sqrt(2)
        .conserves = "momentum",
        .source = "Kutta, Z. Math. Phys. 46 (1901) 435; Hairer, Nørsett, Wanner I, II.1",
        .parameters = parameters,
    };

    static constexpr ButcherTable<4> table{
        .a = {{{0, 0, 0, 0}, {0.5, 0, 0, 0}, {0, 0.5, 0, 0}, {0, 0, 1, 0}}},
        .b = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6},
    };

    template <class T>
    using Integrator = RungeKutta<T, Rk4>;
};

}  // namespace steplab
