#pragma once

#include "methods/engines/splitting.hpp"

namespace steplab {

/// 17 steps of velocity-verlet, symmetric.
struct KahanLi8 {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "kahan-li-8",
        .name = "Kahan-Li 8",
        .what = "Order 8, for long runs at high accuracy: 17 force evaluations per step, bounded energy error.",
        .order = 8,
        .order_with_drag = 8,
        .order_with_damping = 2,
        .evaluations = 17,
        .linear_limit = 3.0964386800011561,
        .symplectic = true,
        .reversible = true,
        .conserves = "momentum, angular momentum; bounded energy error",
        .source = "Kahan, Li, Math. Comp. 66 (1997) 1089",
        .parameters = parameters,
    };

    static constexpr std::array<long double, 9> w{
        0.13020248308889008087881763L, 0.56116298177510838456196441L,  -0.38947496264484728640807860L,
        0.15884190655515560089621075L, -0.39590389413323757733623154L, 0.18453964097831570709183254L,
        0.25837438768632204729397911L, 0.29501172360931029887096624L,  -0.60550853383003451169892108L};
    static constexpr auto table = composition<17>(
        {w[0], w[1], w[2], w[3], w[4], w[5], w[6], w[7], w[8], w[7], w[6], w[5], w[4], w[3], w[2], w[1], w[0]});

    template <class T>
    using Integrator = Splitting<T, KahanLi8>;
};

}  // namespace steplab
