#pragma once

#include <cmath>
#include <concepts>

namespace steplab {

/// The n-th root of x >= 0 within a few ulp, n >= 1, by Newton's iteration from above: bit-identical on every system,
/// unlike pow of libm. 0 for 0; infinity and NaN are returned unchanged.
template <std::floating_point T>
T root(T x, int n) {
    if (!(x > T(0)) || !std::isfinite(x)) return x;
    int exponent = 0;
    std::frexp(x, &exponent);
    T y = std::ldexp(T(1), exponent >= 0 ? (exponent + n - 1) / n : exponent / n);
    for (;;) {
        T power = T(1);
        for (int k = 1; k < n; ++k) power *= y;
        const T next = ((static_cast<T>(n - 1) * y) + x / power) / static_cast<T>(n);
        if (!(next < y)) return y;
        y = next;
    }
}

}  // namespace steplab
