#pragma once
// Whether a step has seen all that acts in it: what a method that chooses its own steps asks of the accelerations at
// the ends of a step in scenes with forces that are felt at some places alone (has_hidden_forces()).

#include "core/field.hpp"
#include "methods/engines/accelerate.hpp"
#include "methods/engines/collisions.hpp"
#include "methods/engines/gauss_stages.hpp"
#include "methods/engines/longest_step.hpp"
#include "methods/engines/radau.hpp"
#include "methods/engines/series_motion.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <span>

namespace steplab {

template <class T>
T sum_of_squares(const Field<T>& field) {
    T sum = T(0);
    for (const T number : field.flat()) sum += number * number;
    return sum;
}

/// Whether accelerations at the end of a step are as far from its polynomial as smooth ones may be: by less than its
/// last coefficients, than rounding, and than what changes the velocities by the tolerance. All but that (the tolerance
/// over the length of the step) are sums of squares.
template <class T>
bool is_smooth(T gap2, T last_coefficients2, T accelerations2, T velocities2, T change) {
    constexpr T noise = T(1024) * std::numeric_limits<T>::epsilon(), unseen = T(64);
    const T allowed = unseen * change;
    return gap2 <=
           T(4) * last_coefficients2 + noise * noise * accelerations2 + allowed * allowed * (T(1) + velocities2);
}

/// Whether accelerations have a kink within a step, from the squares of their Legendre coefficients: of smooth ones
/// those of the orders 6 and 7 are some hundredths of those of 4 and 5, of others about half. What changes the
/// velocities by less than the tolerance is none.
template <class T>
bool has_kink(T orders_4_and_5, T orders_6_and_7, T velocities2, T change) {
    const T allowed = T(10) * change;
    return orders_6_and_7 > T(0.002) * orders_4_and_5 && orders_6_and_7 > allowed * allowed * (T(1) + velocities2);
}

/// Whether the forces of a scene have seams, where they bend.
template <class System>
bool has_seams(const System& system) {
    if constexpr (requires { system.force().coupling(); }) return !system.force().coupling().smooth;
    return false;
}

/// Of a Gauss-Radau step from `begin`, whose accelerations are those at its beginning and terms b_0 ... b_6: whether
/// those at its end, computed there, are those of its polynomial, and that has no kink. Where they are not something
/// acts behind the last node that was not seen, or not all of it.
template <class System, class T, class Terms>
bool is_foreseen(const System& system, const MotionOf<T>& begin, const Terms& b, const Field<T>& end_a, T change) {
    const auto terms = Radau::numbers(b);
    const T *const a = begin.a.flat().data(), *const end = end_a.flat().data();
    T gap2 = T(0);
    std::array<T, 4> orders{};  // squares of the Legendre coefficients of the orders 4 to 7
    for (std::size_t k = 0; k < end_a.flat().size(); ++k) {
        T gap = end[k] - a[k];
        for (std::size_t i = 0; i < Radau::terms; ++i) gap -= terms[i][k];
        gap2 += gap * gap;
        for (std::size_t order = 4; order <= Radau::terms; ++order) {
            T coefficient = T(0);
            for (std::size_t power = order; power <= Radau::terms; ++power)
                coefficient += static_cast<T>(Radau::legendre(order, power)) * terms[power - 1][k];
            orders[order - 4] += coefficient * coefficient;
        }
    }
    const T velocities2 = sum_of_squares(begin.v), last = orders[2] + orders[3];
    return is_smooth(gap2, last, sum_of_squares(begin.a) + sum_of_squares(end_a), velocities2, change) &&
           !(has_seams(system) && has_kink(orders[0] + orders[1], last, velocities2, change));
}

/// Of a step of the Gauss method from `begin` to displacements `end_x`: the same at both its ends, where it has no
/// stages.
template <class T, class System>
bool is_foreseen(System& system, const MotionOf<T>& begin, const GaussStages<T>& stages, const Field<T>& end_x,
                 T change) {
    Field<T> end_f(end_x.count()), begin_f = begin.a;
    system.accelerations(end_x, end_f);
    add_drag(-system.drag(), begin.v, begin_f);  // the stages' forces are without it
    const auto spectrum = stages.spectrum();
    const T velocities2 = sum_of_squares(begin.v), last = spectrum.coefficient_6 + spectrum.coefficient_7;
    return is_smooth(stages.gap_at_ends(begin_f, end_f), last, spectrum.force, velocities2, change) &&
           !(has_seams(system) && has_kink(stages.coefficients_4_and_5(), last, velocities2, change));
}

/// Of a motion by a series of this length and tolerance: whether its accelerations are those computed there. The last
/// terms of those of the series are of the tolerance over the square of its length.
template <class T>
bool is_foreseen(const Motion<T>& then, const Field<T>& computed, T tolerance, T length) {
    constexpr T terms = T(128);
    T gap2 = T(0);
    for (std::size_t k = 0; k < computed.flat().size(); ++k) {
        const T gap = computed.flat()[k] - then.a.flat()[k];
        gap2 += gap * gap;
    }
    const T change = tolerance / length, last = terms * change / length;
    return is_smooth(gap2, last * last * (T(1) + sum_of_squares(then.x)), sum_of_squares(computed),
                     sum_of_squares(then.v), change);
}

/// The length, no longer than this, of a series whose accelerations are the true ones at its end: it ends before
/// something acts that is in none of its terms.
template <class T, class System>
T foreseen_length(System& system, std::span<const Field<T>> x, const Field<T>& v, T unit, std::size_t axes, T length,
                  T tolerance) {
    if (!has_hidden_forces(system)) return length;
    Motion<T> then(v.count());
    Field<T> computed(v.count());
    for (int halvings = 0; halvings < 100; ++halvings) {
        series_motion(x, v, unit, length, axes, then);
        accelerate(system, then.x, then.v, computed);
        if (is_foreseen(then, computed, tolerance, length)) break;
        length /= T(2);
    }
    return length;
}

}  // namespace steplab
