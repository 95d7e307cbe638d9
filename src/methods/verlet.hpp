#pragma once

#include "core/entry.hpp"
#include "methods/engines/three_point.hpp"

namespace steplab {

/// Störmer-Verlet in its three-point form. It starts from x(1) = x0 + dt (1 - f) v0 + dt^2/2 a0 and outputs v(n) =
/// (x(n+1) - x(n-1)) / (2 dt), the velocity at the time of x(n).
struct Verlet {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "verlet",
        .name = "Störmer-Verlet",
        .what = "The workhorse of molecular dynamics: cheap, time-reversible, bounded energy error.",
        .order = 2,
        .order_with_drag = 2,
        .order_with_damping = 2,
        .evaluations = 1,
        .linear_limit = 2,
        .symplectic = true,
        .reversible = true,
        .conserves = "momentum, angular momentum; bounded energy error",
        .source = "Verlet, Phys. Rev. 159 (1967) 98; Hairer, Lubich, Wanner, Acta Numerica 12 (2003) 399",
        .parameters = parameters,
    };

    template <class T>
    struct Integrator : ThreePoint<T> {
        explicit Integrator(const ParameterValues& values) : ThreePoint<T>(values, 1) {}
    };
};

}  // namespace steplab
