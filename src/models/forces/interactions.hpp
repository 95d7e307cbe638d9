#pragma once

#include "core/block.hpp"
#include "core/dual.hpp"
#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "models/forces/morse_pair.hpp"
#include "models/forces/spring.hpp"

namespace steplab {

// The formulas of the interactions in layouts (core/force_layout.hpp), and their derivatives.

/// A spring: its pull divided by the mass of a particle. With rest length 0 it is linear; the general formula, 0 / 0 at
/// distance 0, would not give its derivative.
template <class T>
struct SpringFormula {
    Vector<T> rest;  ///< vector along the spring at e = 0
    T length;
    T stiffness;  ///< k / m

    template <class N>
    Vector<N> operator()(const N& ex, const N& ey, const N& ez) const {
        if (length == T(0)) return {N(stiffness) * ex, N(stiffness) * ey, N(stiffness) * ez};
        return spring_pull(Vector<N>{N(rest.x), N(rest.y), N(rest.z)}, N(length), N(stiffness), Vector<N>{ex, ey, ez});
    }
};

/// A Morse pair. The distance vector of the formula is opposite to e; the pull is an odd function of it.
template <class T, template <class> class Constants = MorseConstants>
struct MorseFormula {
    Constants<T> morse;
    Vector<T> rest{T(0), T(0), T(0)};

    template <class N>
    Vector<N> operator()(const N& ex, const N& ey, const N& ez) const {
        const auto constants = constants_as<N>(morse);
        const Vector<N> push = morse_pull(constants, Vector<N>{ex, ey, ez});
        return {N(T(0)) - push.x, N(T(0)) - push.y, N(T(0)) - push.z};
    }
};

/// The exact derivative of a formula with respect to e, by dual numbers; `properties` of the pair where it takes them.
template <class T, class Formula, class... Properties>
Block<T> derivative(const Formula& formula, const Vector<T>& e, const Properties&... properties) {
    using D = Dual<T>;
    Block<T> block;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto along = [axis](std::size_t a) { return a == axis ? T(1) : T(0); };
        const Vector<D> slope = formula(D(e.x, along(0)), D(e.y, along(1)), D(e.z, along(2)), properties...);
        block.at[0][axis] = slope.x.derivative;
        block.at[1][axis] = slope.y.derivative;
        block.at[2][axis] = slope.z.derivative;
    }
    return block;
}

/// The difference e of two particles' displacements, the argument of the formulas.
template <class Force, class T>
Vector<T> difference(const Force& force, const Field<T>& u, std::size_t i, std::size_t j) {
    if constexpr (Force::capabilities.periodic) {
        return force.difference(u, i, j);
    } else {
        return {u.x()[j] - u.x()[i], u.y()[j] - u.y()[i], u.z()[j] - u.z()[i]};
    }
}

/// Calls f(i, j, block) for every interacting pair: block is the derivative of the acceleration of i with respect to
/// u_j and of that of j with respect to u_i; with respect to their own displacements it is the opposite. Where
/// particles differ in mass it is that of the force, in the unit of mass. Of what acts on a particle from outside the
/// block is the opposite of the derivative, and i = j.
template <class Force, class T, class F>
void each_block(Force& force, const Field<T>& u, F f) {
    const auto formulas = force.formulas();
    force.each_interaction(u, [&](std::size_t i, std::size_t j, std::size_t kind) {
        const auto& formula = formulas[kind];
        if constexpr (Force::capabilities.masses) {
            const PairProperties<T> of = force.properties(i, j, kind);
            const PairProperties<Dual<T>> properties{of.first_mass, of.second_mass, of.first_charge, of.second_charge};
            if (i == j) return f(i, j, T(-1) * derivative(formula, force.place(u, i), properties));
            f(i, j, derivative(formula, difference(force, u, i, j), properties));
        } else {
            f(i, j, derivative(formula, difference(force, u, i, j)));
        }
    });
}

}  // namespace steplab
