#pragma once

#include "core/entry.hpp"
#include "methods/engines/embedded_runge_kutta.hpp"

namespace steplab {

/// Runge-Kutta 5(4) of Dormand and Prince with dense output of order 4.
struct Dopri5 {
    static constexpr ParameterInfo parameters[] = {tolerance_parameter};

    static constexpr MethodInfo info{
        .id = "dopri5",
        .name = "Dormand-Prince 5(4)",
        .what = "Adaptive, order 5: the usual choice for moderate accuracy when little is known about the scene.",
        .order = 5,
        .order_with_drag = 5,
        .order_with_damping = 5,
        .evaluations = 6,
        .start_evaluations = 2,
        .linear_limit = infinity,
        .adaptive = true,
        .conserves = "momentum",
        .source =
            "Dormand, Prince, J. Comput. Appl. Math. 6 (1980) 19; Shampine, Math. Comp. 46 (1986) 135; Hairer, "
            "Nørsett, Wanner I, II.5, II.6",
        .parameters = parameters,
    };

    static constexpr ControlConstants control{.order = 5, .beta = 0.04, .safety = 0.9, .least = 0.2, .most = 10};

    static constexpr EmbeddedTable<7, 0, 1, 1> table{
        .a = {{{},
               {1.0L / 5},
               {3.0L / 40, 9.0L / 40},
               {44.0L / 45, -56.0L / 15, 32.0L / 9},
               {19372.0L / 6561, -25360.0L / 2187, 64448.0L / 6561, -212.0L / 729},
               {9017.0L / 3168, -355.0L / 33, 46732.0L / 5247, 49.0L / 176, -5103.0L / 18656},
               {35.0L / 384, 0, 500.0L / 1113, 125.0L / 192, -2187.0L / 6784, 11.0L / 84}}},
        .error = {{{71.0L / 57600, 0, -71.0L / 16695, 71.0L / 1920, -17253.0L / 339200, 22.0L / 525, -1.0L / 40}}},
        .dense = {{{-12715105075.0L / 11282082432, 0, 87487479700.0L / 32700410799, -10690763975.0L / 1880347072,
                    701980252875.0L / 199316789632, -1453857185.0L / 822651844, 69997945.0L / 29380423}}},
    };

    template <class T>
    using Integrator = AdaptiveSteps<T, EmbeddedRungeKutta<T, Dopri5>>;
};

}  // namespace steplab
