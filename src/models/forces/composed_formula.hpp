#pragma once

#include "core/force_layout.hpp"
#include "core/vector.hpp"
#include "models/forces/composition.hpp"
#include "models/forces/pair_potential.hpp"
#include "models/forces/spring.hpp"

#include <variant>

namespace steplab {

/// F = k e + quadratic e^2 + cubic e^3 of a spring's extension e, divided by the unit of mass.
template <class T>
struct SpringLaw {
    T length{}, stretch{}, k{}, quadratic{}, cubic{};

    static SpringLaw of(const ComposedSpring& spring, double unit) {
        const auto divided = [unit](double number) { return static_cast<T>(number) / static_cast<T>(unit); };
        return {static_cast<T>(spring.length), static_cast<T>(spring.stretch), divided(spring.k),
                divided(spring.quadratic), divided(spring.cubic)};
    }

    /// The force divided by the length: what the distance vector is multiplied by.
    template <class N>
    N factor(const SpringGeometry<N>& spring) const {
        if (!(quadratic == T(0) && cubic == T(0))) return nonlinear_factor(spring);
        return length == T(0) ? N(k) : linear_factor(spring);
    }
    /// Of a spring with a length and without the other terms.
    template <class N>
    N linear_factor(SpringGeometry<N> spring) const {
        spring.stretch = spring.stretch + N(stretch);
        return spring_factor(spring, N(length), N(k));
    }
    template <class N>
    N nonlinear_factor(const SpringGeometry<N>& spring) const {
        const N extension = (spring.stretch + N(stretch)) / (spring.distance + N(length));
        const N stiffness = N(k) + extension * (N(quadratic) + extension * N(cubic));
        return where(spring.distance2 > N(T(0)), stiffness * extension / spring.distance, N(T(0)));
    }
};

/// One interaction of a composition: the force on its first particle, divided by the unit of mass, of the difference e
/// of their displacements, or of a particle's position in a field.
template <class T>
struct ComposedFormula {
    /// Along these axes it may pull although nothing lies or moves along them.
    Vector<T> rest{T(0), T(0), T(0)};
    std::variant<SpringLaw<T>, const PairPotential<T>*, const FieldPotential<T>*> law;

    template <class N>
    Vector<N> operator()(const N& x, const N& y, const N& z, const PairProperties<N>& particles) const {
        if (const auto* field = std::get_if<const FieldPotential<T>*>(&law))
            return (*field)->force(Vector<N>{x, y, z}, particles.first_mass, particles.first_charge);
        const SpringGeometry<N> pair(Vector<N>{N(rest.x), N(rest.y), N(rest.z)}, Vector<N>{x, y, z});
        if (const auto* spring = std::get_if<SpringLaw<T>>(&law)) return spring->factor(pair) * pair.d;
        const auto* const potential = std::get<const PairPotential<T>*>(law);
        return (N(T(0)) - potential->factor(pair.distance2, particles)) * pair.d;
    }
};

/// The energy of a spring whose ends are displaced by `difference` relative to each other.
template <class T>
double spring_energy(const ComposedSpring& spring, const ComposedFormula<T>& formula, const Vector<T>& difference) {
    const SpringLaw<T>& law = *std::get_if<SpringLaw<T>>(&formula.law);
    const SpringGeometry<T> geometry(formula.rest, difference);
    const T denominator = geometry.distance + law.length;
    const T extension = (geometry.stretch + law.stretch) / where(denominator > T(0), denominator, T(1));
    const auto e = static_cast<double>(extension);
    return e * e * (spring.k / 2 + e * (spring.quadratic / 3 + e * spring.cubic / 4));
}

}  // namespace steplab
