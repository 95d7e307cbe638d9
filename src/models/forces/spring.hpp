#pragma once

#include "core/number.hpp"
#include "core/vector.hpp"

namespace steplab {

/// True if the angle between two distance vectors is 90 degrees or more, or a vector is zero.
template <class N>
bool turned_round(const Vector<N>& from, const Vector<N>& to) {
    return !(from.x * to.x + from.y * to.y + from.z * to.z > N(0));
}

/// A component that is zero by construction: adding it takes no instruction.
struct Zero {
    template <class N>
    friend const N& operator+(Zero, const N& number) {
        return number;
    }
};

/// A constant vector, components of which may be Zero.
template <class X, class Y, class Z>
struct Offset {
    X x;
    Y y;
    Z z;
};

/// The spring formulas, once for every number type. A spring joins two particles whose reference positions differ by
/// `rest` (a Vector or an Offset), |rest| = `length` being its rest length; e is the difference of their displacements.
/// Then d = rest + e, and |d|^2 - length^2 = 2 rest.e + |e|^2 has no cancellation, so that an extension far below the
/// rounding error of positions is accurate.
template <class N>
struct SpringGeometry {
    Vector<N> d;  ///< from the first particle to the second
    N stretch;    ///< |d|^2 - length^2
    N distance2;  ///< |d|^2
    N distance;   ///< |d|

    SpringGeometry() = default;
    template <class Rest>
    [[gnu::always_inline]] SpringGeometry(const Rest& rest, const Vector<N>& e)
        : d{rest.x + e.x, rest.y + e.y, rest.z + e.z},
          stretch(e.x * (rest.x + d.x) + (e.y * (rest.y + d.y) + e.z * (rest.z + d.z))),
          distance2(d.x * d.x + (d.y * d.y + d.z * d.z)),
          distance(square_root(distance2)) {}

    /// The same numbers for a spring that lies and moves along x: the root of a square is exactly the absolute value.
    [[gnu::always_inline]] static SpringGeometry along_x(const N& rest, const N& e) {
        const N zero(0);
        SpringGeometry spring;
        spring.d = {rest + e, zero, zero};
        spring.stretch = e * (rest + spring.d.x);
        spring.distance2 = spring.d.x * spring.d.x;
        spring.distance = magnitude(spring.d.x);
        return spring;
    }
};

/// stiffness (|d| - length) / |d|. Always inlined: whole registers of numbers would be passed through memory. The
/// denominator is 0 where |d|^2 is, which is known before the root. NaN where |d|^2 overflows.
template <class N>
[[gnu::always_inline]] inline N spring_factor(const SpringGeometry<N>& spring, const N& length, const N& stiffness) {
    const N denominator = spring.distance2 + length * spring.distance;
    return where(spring.distance2 > N(0), stiffness * spring.stretch / denominator, stiffness);
}

/// This times d: the pull of a spring on its first particle. Zero for coincident particles; the derivative there is
/// that of a spring of rest length 0.
template <class N>
[[gnu::always_inline]] inline Vector<N> spring_pull(const SpringGeometry<N>& spring, const N& length,
                                                    const N& stiffness) {
    return spring_factor(spring, length, stiffness) * spring.d;
}
template <class Rest, class N>
[[gnu::always_inline]] inline Vector<N> spring_pull(const Rest& rest, const N& length, const N& stiffness,
                                                    const Vector<N>& e) {
    return spring_pull(SpringGeometry<N>(rest, e), length, stiffness);
}

/// (|d| - length)^2 / 2: the energy of a spring of force constant 1.
template <class Rest, class N>
[[gnu::always_inline]] inline N spring_energy(const Rest& rest, const N& length, const Vector<N>& e) {
    const SpringGeometry<N> spring(rest, e);
    const N denominator = spring.distance + length;
    const N extension = spring.stretch / where(denominator > N(0), denominator, N(1));
    return extension * extension / N(2);
}

}  // namespace steplab
