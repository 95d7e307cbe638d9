#pragma once

#include "core/number.hpp"
#include "core/stages.hpp"

#include <cmath>
#include <type_traits>

namespace steplab {

/// (e^z - 1) / z, 1 at z = 0: the function phi_1 of exponential integrators, for equations with linear decay (
/// Hochbruck, Ostermann, Acta Numerica 19 (2010) 209). Near 0 it is computed from its series, to avoid cancellation;
/// float is computed in double. Bit-identical on every system.
template <class T>
T phi_1(T z) {
    using Wide = std::conditional_t<std::is_same_v<T, float>, double, T>;
    const Wide x = z;
    if (std::abs(x) > Wide(0.5)) return static_cast<T>((exponential(x) - Wide(1)) / x);
    Wide sum = 0;
    for (int k = 18; k >= 1; --k) sum = (Wide(1) + sum) * x / static_cast<Wide>(k + 1);  // 0.5^18 / 19! = 3e-23
    return static_cast<T>(Wide(1) + sum);
}

/// The same in every lane, bit-identical to a single number.
template <HasLanes N>
N phi_1(N z) {
    return N::each([&](std::size_t lane) { return phi_1(z[lane]); });
}

}  // namespace steplab
