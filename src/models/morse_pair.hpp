#pragma once

#include "models/spring.hpp"

namespace steplab {

/// Constants of the Morse potential V(r) = D [(1 - exp(-b (r - r0)))^2 - 1] between particles of one mass.
template <class N>
struct MorseConstants {
    N depth;     ///< D
    N b;         ///< sqrt(k / (2 D))
    N r0;        ///< distance of the minimum, V(r0) = -D
    N strength;  ///< 2 b D / m
};

/// Acceleration of the particle at distance vector d from another, by that other. Zero for coincident particles.
template <class N>
[[gnu::always_inline]] inline Vector<N> morse_pull(const MorseConstants<N>& morse, const Vector<N>& d) {
    const N distance = square_root(d.x * d.x + d.y * d.y + d.z * d.z);
    const N e = exponential(morse.b * (morse.r0 - distance));
    const N factor = morse.strength * e * (e - N(1)) / where(distance > N(0), distance, N(1));
    return {factor * d.x, factor * d.y, factor * d.z};
}

/// V at this distance.
template <class N>
N morse_energy(const MorseConstants<N>& morse, N distance) {
    const N e = exponential(morse.b * (morse.r0 - distance));
    return morse.depth * e * (e - N(2));
}

}  // namespace steplab
