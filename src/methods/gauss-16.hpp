#pragma once

#include "core/entry.hpp"
#include "methods/engines/gauss.hpp"

namespace steplab {

/// Gauss collocation of order 16 with its eight stages in the lanes of one register.
struct Gauss16 {
    static constexpr ParameterInfo parameters[] = {
        {.name = "tolerance",
         .kind = ParameterInfo::Kind::real,
         .unit = "",
         .minimum = 0,
         .default_value = 0,
         .what = "0: fixed steps dt; > 0: allowed error per step, the method then chooses its steps",
         .slider_high = 1e-2},
    };

    static constexpr MethodInfo info{
        .id = "gauss-16",
        .name = "Gauss 16",
        .what = "Implicit, order 16: accurate to rounding at large dt, with a bounded energy error over any time.",
        .order = 16,
        .order_with_drag = 16,
        .evaluations = 64,  // typically eight iterations of eight stages
        .start_evaluations = 1,
        // The method itself is stable at any dt. Its iteration converges up to omega dt = 6.5; beyond that, half steps
        // are taken.
        .linear_limit = infinity,
        .symplectic = true,
        .reversible = true,
        .implicit = true,
        .conserves = "momentum, angular momentum; bounded energy error",
        .source = "Antoñana, Makazaga, Murua, arXiv:2511.03655; Butcher, Math. Comp. 18 (1964) 50",
        .parameters = parameters,
    };

    template <class T>
    using Integrator = Gauss<T>;
};

}  // namespace steplab
