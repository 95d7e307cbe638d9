#pragma once

#include "methods/engines/splitting.hpp"

namespace steplab {

/// Kick b1, drift a1, ..., kick b6, drift a6; not symmetric.
struct MclachlanAtela5 {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "mclachlan-atela-5",
        .name = "McLachlan-Atela 5",
        .what = "Order 5 with six force evaluations per step; symplectic but not time-reversible; order 3 with drag.",
        .order = 5,
        .order_with_drag = 3,
        .order_with_damping = 2,
        .evaluations = 6,
        .linear_limit = 3.0624976839833413,
        .symplectic = true,
        .conserves = "momentum, angular momentum; bounded energy error",
        .source = "McLachlan, Atela, Nonlinearity 5 (1992) 541",
        .parameters = parameters,
    };

    static constexpr std::array<KickAndDrift, 6> table{{{0.1193900292875672758L, 0.339839625839110000L},
                                                        {0.6989273703824752308L, -0.088601336903027329L},
                                                        {-0.1713123582716007754L, 0.5858564768259621188L},
                                                        {0.4012695022513534480L, -0.603039356536491888L},
                                                        {0.0107050818482359840L, 0.3235807965546976394L},
                                                        {-0.0589796254980311632L, 0.4423637942197494587L}}};

    template <class T>
    using Integrator = Splitting<T, MclachlanAtela5>;
};

}  // namespace steplab
