#pragma once

#include "methods/engines/splitting.hpp"

namespace steplab {

/// Three steps of velocity-verlet, the second one backwards in time.
struct ForestRuth {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "forest-ruth",
        .name = "Forest-Ruth 4",
        .what = "The first symplectic method of order 4: simple, but its long backward substep makes the errors large.",
        .order = 4,
        .order_with_drag = 4,
        .order_with_damping = 2,
        .evaluations = 3,
        .linear_limit = 1.5734019474345436,
        .symplectic = true,
        .reversible = true,
        .conserves = "momentum, angular momentum; bounded energy error",
        .source = "Forest, Ruth, Physica D 43 (1990) 105; Yoshida, Phys. Lett. A 150 (1990) 262",
        .parameters = parameters,
    };

    static constexpr long double c = 1.35120719195965763404768780897146L;  // 1 / (2 - 2^(1/3))
    static constexpr auto table = composition<3>({c, 1 - 2 * c, c});

    template <class T>
    using Integrator = Splitting<T, ForestRuth>;
};

}  // namespace steplab
