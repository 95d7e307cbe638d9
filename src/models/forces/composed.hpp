#pragma once

#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "core/sum.hpp"
#include "core/vector.hpp"
#include "models/forces/forces.hpp"
#include "models/forces/interactions.hpp"
#include "models/forces/neighbours.hpp"
#include "models/forces/pair_potential.hpp"
#include "models/forces/spring.hpp"
#include "models/periods.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace steplab {

/// One interaction of a composition: the force on its first particle, divided by the unit of mass, of the difference e
/// of their displacements.
template <class T>
struct ComposedFormula {
    Vector<T> rest{T(0), T(0), T(0)};
    bool is_spring = true;
    T length = T(0), stretch = T(0), k = T(0), quadratic = T(0),
      cubic = T(0);  ///< of a spring, divided by the unit of mass
    const PairPotential<T>* potential = nullptr;
    T per_mass = T(1);  ///< of a potential

    template <class N>
    Vector<N> operator()(const N& ex, const N& ey, const N& ez) const {
        const Vector<N> e{ex, ey, ez};
        const SpringGeometry<N> spring(Vector<N>{N(rest.x), N(rest.y), N(rest.z)}, e);
        return (is_spring ? of_spring(spring) : N(T(0)) - N(per_mass) * potential->factor(spring.distance2)) * spring.d;
    }

private:
    template <class N>
    N of_spring(SpringGeometry<N> spring) const {
        const bool linear = quadratic == T(0) && cubic == T(0);
        if (linear && length == T(0)) return N(k);
        spring.stretch = spring.stretch + N(stretch);
        if (linear) return spring_factor(spring, N(length), N(k));
        const N extension = spring.stretch / (spring.distance + N(length));
        const N stiffness = N(k) + extension * (N(quadratic) + extension * N(cubic));
        return where(spring.distance2 > N(T(0)), stiffness * extension / spring.distance, N(T(0)));
    }
};

/// The engine of ComposedForces: springs in the order of the scene, then pairs term by term in the order of their
/// particles. The sums depend on positions alone.
template <class T>
class Composed {
public:
    static constexpr ForceCapabilities capabilities{.periodic = true, .masses = true};

    explicit Composed(const ComposedForces& forces);

    /// The same forces in another number type.
    template <class N>
    Composed<N> in() const {
        return Composed<N>(forces_);
    }

    void accelerations(const Field<T>& u, Field<T>& a);
    PotentialEnergy potential(const Field<T>& u);

    template <class F>
    void passing_pairs(const Field<T>& from, const Field<T>& to, F f) {
        each_pair(from, [&](std::size_t i, std::size_t j, std::size_t) {
            if (turned_round(separation(from, i, j), separation(to, i, j)))
                f(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
        });
        for (const ComposedSpring& spring : terms().springs) {
            if (turned_round(separation(from, spring.first, spring.second),
                             separation(to, spring.first, spring.second)))
                f(spring.first, spring.second);
        }
    }
    /// The vector from particle i to the nearest image of particle j.
    Vector<T> separation(const Field<T>& u, std::size_t i, std::size_t j) const {
        const Vec d = difference(u, i, j);
        if (reference_.empty()) return d;
        return {d.x + (reference_[j].x - reference_[i].x), d.y + (reference_[j].y - reference_[i].y),
                d.z + (reference_[j].z - reference_[i].z)};
    }
    /// u_j - u_i; in a box to the nearest image.
    Vector<T> difference(const Field<T>& u, std::size_t i, std::size_t j) const {
        return {periods_[0].within(u.x()[j] - u.x()[i]), periods_[1].within(u.y()[j] - u.y()[i]),
                periods_[2].within(u.z()[j] - u.z()[i])};
    }

    Coupling coupling() const { return steplab::coupling(forces_); }
    bool moves(std::size_t i) const { return terms().fixed.empty() || terms().fixed[i] == 0; }
    Vector<T> external(std::size_t i) const {
        if (external_.empty() || !moves(i)) return {T(0), T(0), T(0)};
        return external_.size() == 1 ? external_.front() : external_[i];
    }

    /// Kinds: each spring, then each term of pairs.
    std::span<const ComposedFormula<T>> formulas() const { return formulas_; }
    template <class F>
    void each_interaction(const Field<T>& u, F f) {
        for (std::size_t s = 0; s < terms().springs.size(); ++s)
            f(std::size_t(terms().springs[s].first), std::size_t(terms().springs[s].second), s);
        each_pair(u, [&](std::size_t i, std::size_t j, std::size_t term) { f(i, j, terms().springs.size() + term); });
    }

    /// Of each particle in the unit of mass; empty where all are 1.
    const std::vector<T>& masses() const { return masses_; }
    T inverse_mass(std::size_t i) const { return masses_.empty() ? T(1) : T(1) / masses_[i]; }
    /// What a formula is multiplied by: the product of masses or charges, 1 for other interactions.
    T strength(std::size_t i, std::size_t j, std::size_t kind) const {
        const std::size_t springs = terms().springs.size();
        return kind < springs ? T(1) : pair_strength(kind - springs, i, j);
    }

private:
    using Vec = Vector<T>;

    const Composition& terms() const { return *forces_.terms; }

    T pair_strength(std::size_t term, std::size_t i, std::size_t j) const;
    static Vec at(const Field<T>& field, std::size_t i) { return {field.x()[i], field.y()[i], field.z()[i]}; }
    static void set(Field<T>& field, std::size_t i, const Vec& vector) {
        field.x()[i] = vector.x;
        field.y()[i] = vector.y;
        field.z()[i] = vector.z;
    }
    bool acts(std::size_t term, std::size_t i, std::size_t j) const;
    template <class F>
    void each_candidate(std::size_t term, const Field<T>& u, F f);
    /// Calls f(i, j, term) for all pairs that act on each other, term by term.
    template <class F>
    void each_pair(const Field<T>& u, F f);
    void add_springs(const Field<T>& u, Field<T>& a) const;
    void add_pairs(std::size_t term, const Field<T>& u, Field<T>& a);
    void add(Field<T>& a, std::size_t i, std::size_t j, const Vec& force) const;
    double external_energy(std::size_t i, const Field<T>& u) const;
    double spring_energy_of(std::size_t s, const Field<T>& u) const;
    void prepare_pairs();

    ComposedForces forces_;
    std::shared_ptr<const std::vector<PairPotential<T>>> potentials_;
    std::vector<ComposedFormula<T>> formulas_;
    std::vector<T> masses_, charges_;
    std::vector<Vec> external_;
    std::vector<Vec> reference_;
    std::array<Periods<T>, 3> periods_;
    /// Of each term of pairs: 1 for the particles of its first set, 2 for those of its second; 3 within one.
    std::vector<std::vector<unsigned char>> sides_;
    std::vector<std::optional<Neighbours>> neighbours_;  ///< of each term with a cut-off
};

template <class T>
Composed<T>::Composed(const ComposedForces& forces)
    : forces_(forces), periods_{Periods<T>(terms().box.x), Periods<T>(terms().box.y), Periods<T>(terms().box.z)} {
    const auto number = [](double value) { return static_cast<T>(value); };
    const auto vector = [&](Vec3 v) { return Vec{number(v.x), number(v.y), number(v.z)}; };
    const double unit = terms().mass;
    auto potentials = std::make_shared<std::vector<PairPotential<T>>>();
    for (const ComposedPairs& pairs : terms().pairs) potentials->emplace_back(pairs);
    potentials_ = std::move(potentials);
    for (const ComposedSpring& spring : terms().springs) {
        ComposedFormula<T> formula;
        formula.rest = vector(spring.rest);
        formula.length = number(spring.length);
        formula.stretch = number(spring.stretch);
        formula.k = number(spring.k) / number(unit);
        formula.quadratic = number(spring.quadratic) / number(unit);
        formula.cubic = number(spring.cubic) / number(unit);
        formulas_.push_back(formula);
    }
    for (const PairPotential<T>& potential : *potentials_) {
        ComposedFormula<T> formula;
        formula.is_spring = false;
        formula.potential = &potential;
        formula.per_mass = T(1) / number(unit);
        formulas_.push_back(formula);
    }
    for (const double mass : terms().masses) masses_.push_back(number(mass));
    for (const double charge : terms().charges) charges_.push_back(number(charge));
    for (const Vec3 acceleration : terms().accelerations) external_.push_back(vector(acceleration));
    for (const Vec3 position : terms().reference) reference_.push_back(vector(position));
    prepare_pairs();
}

template <class T>
void Composed<T>::prepare_pairs() {
    const Vec3 box = terms().box;
    const bool cubic = box.x == box.y && box.y == box.z;
    for (const ComposedPairs& pairs : terms().pairs) {
        std::vector<unsigned char>& sides = sides_.emplace_back(forces_.count);
        for (const std::uint32_t i : pairs.first) sides[i] = pairs.second.empty() ? 3 : 1;
        for (const std::uint32_t i : pairs.second) sides[i] = sides[i] == 1 ? 3 : 2;
        neighbours_.emplace_back();
        if (pairs.cutoff > 0 && cubic) neighbours_.back().emplace(pairs.cutoff, box.x);
    }
}

template <class T>
T Composed<T>::pair_strength(std::size_t term, std::size_t i, std::size_t j) const {
    using Potential = ComposedPairs::Potential;
    const Potential potential = terms().pairs[term].potential;
    if (potential == Potential::coulomb) return charges_[i] * charges_[j];
    if (potential != Potential::gravity) return T(1);
    const T unit = static_cast<T>(terms().mass), masses = masses_.empty() ? T(1) : masses_[i] * masses_[j];
    return masses * unit * unit;
}

template <class T>
bool Composed<T>::acts(std::size_t term, std::size_t i, std::size_t j) const {
    const std::vector<unsigned char>& sides = sides_[term];
    const bool across = ((sides[i] & 1) != 0 && (sides[j] & 2) != 0) || ((sides[i] & 2) != 0 && (sides[j] & 1) != 0);
    return across && (moves(i) || moves(j));
}

/// Calls f(i, j), i < j, for all pairs of a term; of one with a cut-off at least those within it.
template <class T>
template <class F>
void Composed<T>::each_candidate(std::size_t term, const Field<T>& u, F f) {
    if (neighbours_[term]) neighbours_[term]->follow(u);
    for (std::size_t i = 0; i < forces_.count; ++i) {
        if (sides_[term][i] == 0) continue;
        const auto visit = [&](std::size_t j) {
            if (acts(term, i, j)) f(i, j);
        };
        if (neighbours_[term]) {
            for (const std::uint32_t j : neighbours_[term]->of(i)) {
                if (j > i) visit(j);
            }
        } else {
            for (std::size_t j = i + 1; j < forces_.count; ++j) visit(j);
        }
    }
}

template <class T>
template <class F>
void Composed<T>::each_pair(const Field<T>& u, F f) {
    for (std::size_t term = 0; term < potentials_->size(); ++term) {
        const PairPotential<T>& potential = (*potentials_)[term];
        each_candidate(term, u, [&](std::size_t i, std::size_t j) {
            const Vec d = difference(u, i, j);
            const T distance2 = d.x * d.x + d.y * d.y + d.z * d.z;
            if (!potential.cut() || distance2 < potential.cutoff() * potential.cutoff()) f(i, j, term);
        });
    }
}

template <class T>
void Composed<T>::accelerations(const Field<T>& u, Field<T>& a) {
    for (std::size_t i = 0; i < forces_.count; ++i) set(a, i, external(i));
    add_springs(u, a);
    for (std::size_t term = 0; term < potentials_->size(); ++term) add_pairs(term, u, a);
    for (std::size_t i = 0; i < forces_.count; ++i) {
        if (!moves(i)) set(a, i, {T(0), T(0), T(0)});
    }
}

template <class T>
void Composed<T>::add_springs(const Field<T>& u, Field<T>& a) const {
    for (std::size_t s = 0; s < terms().springs.size(); ++s) {
        const std::size_t i = terms().springs[s].first, j = terms().springs[s].second;
        const Vec e = difference(u, i, j);
        add(a, i, j, formulas_[s](e.x, e.y, e.z));
    }
}

template <class T>
void Composed<T>::add_pairs(std::size_t term, const Field<T>& u, Field<T>& a) {
    const PairPotential<T>& potential = (*potentials_)[term];
    const T zero(0), one(1), cutoff2 = potential.cutoff() * potential.cutoff();
    const T per_mass = formulas_[terms().springs.size() + term].per_mass;
    each_candidate(term, u, [&](std::size_t i, std::size_t j) {
        const Vec d = difference(u, i, j);
        const T distance2 = d.x * d.x + d.y * d.y + d.z * d.z;
        if constexpr (std::floating_point<T>) {
            if (potential.cut() && !(distance2 < cutoff2)) return;
        }
        T push = where(distance2 > zero, potential.factor(where(distance2 > zero, distance2, one)), zero);
        if (potential.cut()) push = where(distance2 < cutoff2, push, zero);
        add(a, i, j, (zero - pair_strength(term, i, j) * per_mass * push) * d);
    });
}

/// A force on particle i, divided by the unit of mass, and its opposite on particle j.
template <class T>
void Composed<T>::add(Field<T>& a, std::size_t i, std::size_t j, const Vec& force) const {
    set(a, i, at(a, i) + inverse_mass(i) * force);
    set(a, j, at(a, j) - inverse_mass(j) * force);
}

template <class T>
PotentialEnergy Composed<T>::potential(const Field<T>& u) {
    CompensatedSum value, magnitude, external_value;
    const auto count = [&](double energy) { value.add(energy), magnitude.add(std::abs(energy)); };
    for (std::size_t s = 0; s < terms().springs.size(); ++s) {
        const ComposedSpring& spring = terms().springs[s];
        if (moves(spring.first) || moves(spring.second)) count(spring_energy_of(s, u));
    }
    for (std::size_t term = 0; term < potentials_->size(); ++term) {
        const PairPotential<T>& potential = (*potentials_)[term];
        each_candidate(term, u, [&](std::size_t i, std::size_t j) {
            const Vec d = difference(u, i, j);
            const T distance2 = d.x * d.x + d.y * d.y + d.z * d.z;
            if (potential.cut() && !(distance2 < potential.cutoff() * potential.cutoff())) return;
            const T energy = distance2 > T(0) ? potential.energy(distance2) : potential.energy_of_coincident();
            count(static_cast<double>(pair_strength(term, i, j) * energy));
        });
    }
    for (std::size_t i = 0; i < forces_.count; ++i) {
        if (external_.empty() || !moves(i)) continue;
        const double energy = external_energy(i, u);
        count(energy), external_value.add(energy);
    }
    return {value.value(), magnitude.value(), external_value.value()};
}

/// -m a.x, x the position.
template <class T>
double Composed<T>::external_energy(std::size_t i, const Field<T>& u) const {
    const Vec a = external(i), from = reference_.empty() ? Vec{T(0), T(0), T(0)} : reference_[i];
    const auto product = [](T slope, T start, T shift) {
        return static_cast<double>(slope) * (static_cast<double>(start) + static_cast<double>(shift));
    };
    const double mass = terms().mass * (masses_.empty() ? 1 : terms().masses[i]);
    return -mass * (product(a.x, from.x, u.x()[i]) + product(a.y, from.y, u.y()[i]) + product(a.z, from.z, u.z()[i]));
}

template <class T>
double Composed<T>::spring_energy_of(std::size_t s, const Field<T>& u) const {
    const ComposedSpring& spring = terms().springs[s];
    const SpringGeometry<T> geometry(formulas_[s].rest, difference(u, spring.first, spring.second));
    const T denominator = geometry.distance + formulas_[s].length;
    const T extension = (geometry.stretch + formulas_[s].stretch) / where(denominator > T(0), denominator, T(1));
    const auto e = static_cast<double>(extension);
    return e * e * (spring.k / 2 + e * (spring.quadratic / 3 + e * spring.cubic / 4));
}

}  // namespace steplab
