#pragma once

#include "methods/engines/runge_kutta.hpp"

namespace steplab {

/// The explicit midpoint rule, the thesis' RK2.
struct Midpoint {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "midpoint",
        .name = "Midpoint (RK2)",
        .what = "Uses the force at the middle of the step; its energy grows at any dt, slowly if dt is small.",
        .order = 2,
        .order_with_drag = 2,
        .order_with_damping = 2,
        .evaluations = 2,
        .linear_limit = 0,  // grows by sqrt(1 + (omega dt)^4 / 4) per step
        .conserves = "momentum",
        .source = "Runge, Math. Ann. 46 (1895) 167; Hairer, Nørsett, Wanner I, II.1",
        .parameters = parameters,
    };

    static constexpr ButcherTable<2> table{.a = {{{0, 0}, {0.5, 0}}}, .b = {0, 1}};

    template <class T>
    using Integrator = RungeKutta<T, Midpoint>;
};

}  // namespace steplab
