#pragma once

#include "core/power_of_two.hpp"
#include "models/spring.hpp"

namespace steplab {

/// Constants of the Morse potential V(r) = D [(1 - exp(-b (r - r0)))^2 - 1] between particles of one mass.
template <class N>
struct MorseConstants {
    N depth;                             ///< D
    N b;                                 ///< sqrt(k / (2 D))
    N r0;                                ///< distance of the minimum, V(r0) = -D
    N strength;                          ///< 2 b D / m
    N b2 = b / N(0.693147180559945309);  ///< e^(b s) = 2^(b2 s)
};

/// The same constants as numbers of another type.
template <class N, class T>
MorseConstants<N> constants_as(const MorseConstants<T>& morse) {
    return {N(morse.depth), N(morse.b), N(morse.r0), N(morse.strength), N(morse.b2)};
}

/// Pull over distance at this distance: the factor of a distance vector. At distance 0 it is finite.
template <class N>
[[gnu::always_inline]] inline N morse_factor(const MorseConstants<N>& morse, const N& distance) {
    const N divisor = where(distance > N(0), distance, N(1));
    if constexpr (WithPowersOfTwo<N>) {
        // strength e (e - 1) / distance with e = a / c: one division for both
        const auto [a, c] = power_of_two(morse.b2 * (morse.r0 - distance));
        return morse.strength * a * (a - c) / (c * c * divisor);
    } else {
        const N e = exponential(morse.b * (morse.r0 - distance));
        return morse.strength * e * (e - N(1)) / divisor;
    }
}

/// Acceleration of the particle at distance vector d from another, by that other. Zero for coincident particles.
template <class N>
[[gnu::always_inline]] inline Vector<N> morse_pull(const MorseConstants<N>& morse, const Vector<N>& d) {
    return morse_factor(morse, square_root(d.x * d.x + d.y * d.y + d.z * d.z)) * d;
}

/// V at this distance.
template <class N>
N morse_energy(const MorseConstants<N>& morse, N distance) {
    const N e = exponential(morse.b * (morse.r0 - distance));
    return morse.depth * e * (e - N(2));
}

}  // namespace steplab
