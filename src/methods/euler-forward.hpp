#pragma once

#include "methods/engines/runge_kutta.hpp"

namespace steplab {

/// Position and velocity both advance with their derivatives at the start of the step.
struct EulerForward {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "euler-forward",
        .name = "Explicit Euler",
        .what = "The explicit (forward) Euler method, for comparison: its energy grows at any dt.",
        .order = 1,
        .order_with_drag = 1,
        .order_with_damping = 1,
        .evaluations = 1,
        .linear_limit = 0,  // grows by sqrt(1 + (omega dt)^2) per step
        .conserves = "momentum",
        .source = "Euler 1768; Hairer, Nørsett, Wanner I, I.7",
        .parameters = parameters,
    };

    static constexpr ButcherTable<1> table{.a = {{{0}}}, .b = {1}};

    template <class T>
    using Integrator = RungeKutta<T, EulerForward>;
};

}  // namespace steplab
