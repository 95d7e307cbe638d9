#pragma once

#include "core/entry.hpp"
#include "methods/engines/three_point.hpp"

namespace steplab {

/// Störmer's rule: z substeps of the three-point rule, started and ended with velocities at full steps.
struct Stoermer {
    static constexpr ParameterInfo substeps{.name = "substeps",
                                            .kind = ParameterInfo::Kind::integer,
                                            .unit = "",
                                            .minimum = 1,
                                            .maximum = 1000000,
                                            .default_value = 10,
                                            .what = "number of substeps z per step",
                                            .slider_low = 1,
                                            .slider_high = 50};
    static constexpr ParameterInfo parameters[] = {substeps, compensated_sums};

    static constexpr MethodInfo info{
        .id = "stoermer",
        .name = "Störmer",
        .what = "Verlet with z substeps per step: z times the cost, z² times smaller errors, z times the stable dt.",
        .order = 2,
        .order_with_drag = 2,
        .order_with_damping = 2,
        .evaluations = 1,
        .linear_limit = 2,
        .symplectic = true,
        .reversible = true,
        .conserves = "momentum, angular momentum; bounded energy error",
        .source = "Störmer 1907; Press et al., Numerical Recipes, 17.4",
        .parameters = parameters,
    };

    template <class T>
    struct Integrator : ThreePoint<T> {
        explicit Integrator(const ParameterValues& values) : ThreePoint<T>(values, values.count(substeps.name)) {}
    };
};

}  // namespace steplab
