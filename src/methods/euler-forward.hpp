#pragma once

#include "methods/engines/runge_kutta.hpp"

namespace steplab {

/// Position and velocity both move along the slopes at the start of the step.
struct EulerForward {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "euler-forward",
        .name = "Euler, forward",
        .what = "The other Euler, to compare with: it gains energy at any dt.",
        .order = 1,
        .order_with_drag = 1,
        .evaluations = 1,
        .linear_limit = 0,  // grows by sqrt(1 + (omega dt)^2) a step
        .conserves = "momentum",
        .source = "Euler 1768; Hairer, Nørsett, Wanner I, I.7",
        .parameters = parameters,
    };

    static constexpr ButcherTable<1> table{.a = {{{0}}}, .b = {1}};

    template <class T>
    using Integrator = RungeKutta<T, EulerForward>;
};

}  // namespace steplab
