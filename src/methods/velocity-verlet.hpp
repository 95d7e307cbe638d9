#pragma once

#include "methods/engines/splitting.hpp"

namespace steplab {

/// Half a kick, a drift, half a kick.
struct VelocityVerlet {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "velocity-verlet",
        .name = "Velocity Verlet",
        .what = "Verlet with positions and velocities at the same time: half a kick, a drift, half a kick.",
        .order = 2,
        .order_with_drag = 2,
        .order_with_damping = 2,
        .evaluations = 1,
        .linear_limit = 2,
        .symplectic = true,
        .reversible = true,
        .conserves = "momentum, angular momentum; bounded energy error",
        .source = "Swope et al., J. Chem. Phys. 76 (1982) 637",
        .parameters = parameters,
    };

    static constexpr auto table = composition<1>({1.0L});

    template <class T>
    using Integrator = Splitting<T, VelocityVerlet>;
};

}  // namespace steplab
