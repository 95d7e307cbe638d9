#pragma once

#include "methods/engines/splitting.hpp"

namespace steplab {

/// Runge-Kutta-Nyström splitting of 11 stages, symmetric: kick b1, drift a1, ..., kick b6, drift a6, kick b6, ..., kick
/// b1.
struct Srkn11b {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "srkn-11b",
        .name = "Blanes-Moan 6",
        .what = "Order 6 with the smallest errors for its cost among splitting methods; order 4 with drag.",
        .order = 6,
        .order_with_drag = 4,
        .order_with_damping = 2,
        .evaluations = 11,
        .linear_limit = 3.1414310877753386,
        .symplectic = true,
        .reversible = true,
        .conserves = "momentum, angular momentum; bounded energy error",
        .source = "Blanes, Moan, J. Comput. Appl. Math. 142 (2002) 313, SRKN 11b",
        .parameters = parameters,
    };

    static constexpr std::array<long double, 5> b{0.0414649985182624L, 0.198128671918067L, -0.0400061921041533L,
                                                  0.0752539843015807L, -0.0115113874206879L};
    static constexpr std::array<long double, 5> a{0.123229775946271L, 0.290553797799558L, -0.127049212625417L,
                                                  -0.246331761062075L, 0.357208872795928L};
    static constexpr long double b6 = 0.5L - (b[0] + b[1] + b[2] + b[3] + b[4]);
    static constexpr long double a6 = 1 - 2 * (a[0] + a[1] + a[2] + a[3] + a[4]);
    static constexpr std::array<KickAndDrift, 12> table{{{b[0], a[0]},
                                                         {b[1], a[1]},
                                                         {b[2], a[2]},
                                                         {b[3], a[3]},
                                                         {b[4], a[4]},
                                                         {b6, a6},
                                                         {b6, a[4]},
                                                         {b[4], a[3]},
                                                         {b[3], a[2]},
                                                         {b[2], a[1]},
                                                         {b[1], a[0]},
                                                         {b[0], 0}}};

    template <class T>
    using Integrator = Splitting<T, Srkn11b>;
};

}  // namespace steplab
