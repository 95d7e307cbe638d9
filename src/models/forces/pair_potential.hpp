#pragma once

#include "core/force_layout.hpp"
#include "core/number.hpp"
#include "models/forces/composition.hpp"
#include "models/potentials/expression_potential.hpp"
#include "models/potentials/list.hpp"

#include <cmath>
#include <span>
#include <type_traits>
#include <variant>

namespace steplab {

/// A built-in potential V(r) divided by the unit of mass, shifted to zero at a cut-off c together with its slope: V(r)
/// - V(c) - (r - c) V'(c).
template <class T, class Potential>
class ShiftedPotential {
    using Weight = PotentialInfo::Weight;
    static constexpr Weight weight = Potential::info.weight;

public:
    ShiftedPotential(std::span<const double> values, double cutoff, double unit)
        : potential_(values),
          scale_(static_cast<T>(weight == Weight::masses ? unit : 1 / unit)),
          cut_(cutoff > 0),
          cutoff_(static_cast<T>(cutoff)) {
        if (!cut_) return;
        const PairDistance<T> there{cutoff_ * cutoff_};
        force_there_ = potential_.factor(there) * cutoff_;
        energy_there_ = potential_.energy(there);
    }

    template <class N>
    N factor(const N& distance2, const PairProperties<N>& pair) const {
        const PairDistance<N> at{distance2};
        if constexpr (weight == Weight::none) {
            const N uncut = potential_.factor(at);
            return N(scale_) * (cut_ ? uncut - N(force_there_) * at.inverse() : uncut);
        } else {
            const N strength = weight_of(pair);
            const N uncut = potential_.factor(at, strength);
            return cut_ ? uncut - strength * N(force_there_) * at.inverse() : uncut;
        }
    }
    template <class N>
    N energy(const N& distance2, const PairProperties<N>& pair) const {
        const PairDistance<N> at{distance2};
        const N uncut = potential_.energy(at);
        if (!cut_) return weight_of(pair) * uncut;
        return weight_of(pair) * (uncut - N(energy_there_) + (at.length() - N(cutoff_)) * N(force_there_));
    }

    /// What shifts a potential to a cut-off has a direction everywhere.
    bool jumps_at_contact() const {
        if constexpr (requires { potential_.jumps_at_contact(); }) return cut_ || potential_.jumps_at_contact();
        return true;
    }

private:
    template <class N>
    N weight_of(const PairProperties<N>& pair) const {
        if constexpr (weight == Weight::masses) return N(scale_) * pair.first_mass * pair.second_mass;
        if constexpr (weight == Weight::charges) return N(scale_) * pair.first_charge * pair.second_charge;
        return N(scale_);
    }

    Potential potential_;
    T scale_;
    bool cut_;
    T cutoff_, force_there_ = T(0), energy_there_ = T(0);
};

namespace detail {

template <class T, class List>
struct AnyPotentialOf;
template <class T, template <class> class... Potentials>
struct AnyPotentialOf<T, PotentialList<Potentials...>> {
    using Type = std::variant<ExpressionPotential<T>, ShiftedPotential<T, Potentials<T>>...>;
};

/// The potential of a name.
template <class T, std::size_t Index = 1>
typename AnyPotentialOf<T, BuiltInPotentials>::Type potential_of(const ComposedPairs& pairs, double unit) {
    using Any = typename AnyPotentialOf<T, BuiltInPotentials>::Type;
    if (pairs.expression) return Any(ExpressionPotential<T>(pairs.expression));
    if constexpr (Index + 1 < std::variant_size_v<Any>) {
        if (BuiltInPotentials::infos[Index - 1]->name != pairs.potential)
            return potential_of<T, Index + 1>(pairs, unit);
    }
    return Any(std::in_place_index<Index>, pairs.values, pairs.cutoff, unit);
}

}  // namespace detail

/// Masses or charges.
inline bool takes_properties(const ComposedPairs& pairs) {
    const PotentialInfo* const built_in = built_in_potential(pairs.potential);
    return built_in ? built_in->weight != PotentialInfo::Weight::none : pairs.expression->takes_properties;
}

/// Any pair potential in number type T, divided by the unit of mass and multiplied by the product of masses or charges
/// that it takes.
template <class T>
class PairPotential {
public:
    PairPotential(const ComposedPairs& pairs, double unit)
        : potential_(detail::potential_of<T>(pairs, unit)),
          cut_(pairs.cutoff > 0),
          cutoff_(static_cast<T>(pairs.cutoff)) {}

    bool cut() const { return cut_; }
    T cutoff() const { return cutoff_; }

    /// Calls f with the potential as what it is, for loops over many pairs: its factor(distance2, properties) and
    /// energy(distance2, properties) are those below.
    template <class F>
    decltype(auto) visit(F f) const {
        return std::visit(f, potential_);
    }

    /// The force on a particle at distance vector d from another is this times d, |d|^2 = distance2 > 0 and below the
    /// cut-off. In any number type that is made of T.
    template <class N>
    N factor(const N& distance2, const PairProperties<N>& pair) const {
        return visit([&](const auto& potential) { return potential.factor(distance2, pair); });
    }
    /// V at that distance.
    template <class N>
    N energy(const N& distance2, const PairProperties<N>& pair) const {
        return visit([&](const auto& potential) { return potential.energy(distance2, pair); });
    }
    /// Whether the force changes its direction by a jump where two particles meet.
    bool jumps_at_contact() const {
        return visit([](const auto& potential) { return potential.jumps_at_contact(); });
    }
    /// V at distance 0, if it is finite there; else 0.
    T energy_of_coincident(const PairProperties<T>& pair) const {
        const T energy = this->energy(T(0), pair);
        return std::isfinite(energy) ? energy : T(0);
    }

private:
    typename detail::AnyPotentialOf<T, BuiltInPotentials>::Type potential_;
    bool cut_;
    T cutoff_;
};

}  // namespace steplab
