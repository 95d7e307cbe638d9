#pragma once

#include "core/power_of_two.hpp"
#include "models/forces/spring.hpp"

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

/// The same constants in another number type.
template <class N, class T>
MorseConstants<N> constants_as(const MorseConstants<T>& morse) {
    return {N(morse.depth), N(morse.b), N(morse.r0), N(morse.strength), N(morse.b2)};
}

/// The same potential shifted to zero at a cut-off c, V(r) - V(c) - (r - c) V'(c): neither energy nor force jumps there
/// (shifted forces: Toxvaerd and Dyre, J. Chem. Phys. 134 (2011) 081102). The functions below apply to it where r < c.
template <class N>
struct CutMorseConstants : MorseConstants<N> {
    N cutoff;        ///< c
    N pull_there;    ///< -V'(c) / m
    N energy_there;  ///< V(c)
    N slope_there;   ///< V'(c)
};

template <class N, class T>
CutMorseConstants<N> constants_as(const CutMorseConstants<T>& morse) {
    return {constants_as<N>(static_cast<const MorseConstants<T>&>(morse)), N(morse.cutoff), N(morse.pull_there),
            N(morse.energy_there), N(morse.slope_there)};
}

namespace detail {

/// The pull with the shift of the cut-off, both times a common factor.
template <class Constants, class N, class... Factors>
[[gnu::always_inline]] inline N cut(const Constants& morse, const N& pull, const Factors&... factors) {
    if constexpr (requires { morse.pull_there; }) {
        return pull - (morse.pull_there * ... * factors);
    } else {
        return pull;
    }
}

}  // namespace detail

/// Pull divided by distance: the factor of a distance vector. Finite at distance 0.
template <template <class> class Constants, class N>
[[gnu::always_inline]] inline N morse_factor(const Constants<N>& morse, const N& distance) {
    const N divisor = where(distance > N(0), distance, N(1));
    if constexpr (WithPowersOfTwo<N>) {
        // strength e (e - 1) / distance with e = a / c: one division for both
        const auto [a, c] = power_of_two(morse.b2 * (morse.r0 - distance));
        const N c2 = c * c;
        return detail::cut(morse, morse.strength * a * (a - c), c2) / (c2 * divisor);
    } else {
        const N e = exponential(morse.b * (morse.r0 - distance));
        return detail::cut(morse, morse.strength * e * (e - N(1))) / divisor;
    }
}

/// Acceleration of the particle at distance vector d from another, by that other. Zero for coincident particles.
template <template <class> class Constants, class N>
[[gnu::always_inline]] inline Vector<N> morse_pull(const Constants<N>& morse, const Vector<N>& d) {
    return morse_factor(morse, square_root(d.x * d.x + d.y * d.y + d.z * d.z)) * d;
}

/// V(distance).
template <class N>
N morse_energy(const MorseConstants<N>& morse, N distance) {
    const N e = exponential(morse.b * (morse.r0 - distance));
    return morse.depth * e * (e - N(2));
}
template <class N>
N morse_energy(const CutMorseConstants<N>& morse, N distance) {
    const N energy = morse_energy(static_cast<const MorseConstants<N>&>(morse), distance);
    return energy - morse.energy_there - (distance - morse.cutoff) * morse.slope_there;
}

}  // namespace steplab
