#pragma once

#include "methods/engines/splitting.hpp"

namespace steplab {

/// Position-extended Forest-Ruth-like.
struct Pefrl {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "pefrl",
        .name = "PEFRL 4",
        .what =
            "Order 4 with small errors for four force evaluations per step: the usual choice where Verlet is not "
            "accurate enough.",
        .order = 4,
        .order_with_drag = 4,
        .order_with_damping = 2,
        .evaluations = 4,
        .linear_limit = 2.9894495459067786,
        .symplectic = true,
        .reversible = true,
        .conserves = "momentum, angular momentum; bounded energy error",
        .source = "Omelyan, Mryglod, Folk, Comput. Phys. Commun. 146 (2002) 188",
        .parameters = parameters,
    };

    static constexpr long double xi = 0.1786178958448091L, lambda = -0.2123418310626054L, chi = -0.06626458266981849L;
    static constexpr std::array<KickAndDrift, 5> table{{{.kick = 0, .drift = xi},
                                                        {.kick = (1 - 2 * lambda) / 2, .drift = chi},
                                                        {.kick = lambda, .drift = 1 - 2 * (chi + xi)},
                                                        {.kick = lambda, .drift = chi},
                                                        {.kick = (1 - 2 * lambda) / 2, .drift = xi}}};

    template <class T>
    using Integrator = Splitting<T, Pefrl>;
};

}  // namespace steplab
