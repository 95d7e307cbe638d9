#pragma once

#include "core/field.hpp"
#include "core/field_lanes.hpp"
#include "core/force_layout.hpp"
#include "core/sum.hpp"
#include "core/team.hpp"
#include "core/vector.hpp"
#include "models/forces/composed_approaches.hpp"
#include "models/forces/composed_damping.hpp"
#include "models/forces/composed_fields.hpp"
#include "models/forces/composed_formula.hpp"
#include "models/forces/composed_held.hpp"
#include "models/forces/composed_pairs.hpp"
#include "models/forces/composed_particles.hpp"
#include "models/forces/composed_rows.hpp"
#include "models/forces/composed_springs.hpp"
#include "models/forces/forces.hpp"
#include "models/forces/interactions.hpp"
#include "models/forces/particle_registers.hpp"
#include "models/forces/spring.hpp"
#include "models/forces/spring_rows.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace steplab {

/// The engine of ComposedForces: springs in the order of the scene, then pairs term by term in the order of their
/// particles, then fields. The sums depend on positions alone, but those in float and double by clusters
/// (pair_list.hpp) on the positions at which these were made too.
template <class T>
class Composed {
    static constexpr bool in_registers = std::same_as<T, float> || std::same_as<T, double>;

public:
    static constexpr ForceCapabilities capabilities{.hands_out = in_registers,
                                                    .history = in_registers,
                                                    .periodic = true,
                                                    .masses = true,
                                                    .fields = true,
                                                    .damping = true,
                                                    .approaches = true,
                                                    .holds = true};

    explicit Composed(const ComposedForces& forces);

    /// The same forces in another number type.
    template <class N>
    Composed<N> in() const {
        Composed<N> same(forces_);
        same.approaches_ = approaches_;
        return same;
    }

    void accelerations(const Field<T>& u, Field<T>& a);
    /// The same, passed to a sink: calls sink(r, a) for every register r of particles, by several threads in parallel,
    /// when u of other registers is no longer read.
    template <class Sink>
    void each_acceleration(const Field<T>& u, Sink sink) requires(in_registers);
    /// The same for observers: leaves clusters as they are.
    void uncounted_accelerations(const Field<T>& u, Field<T>& a) requires(in_registers) {
        if (clusters_hold_at(u)) return accelerations(u, a);
        const Field<T> made_at = history();
        accelerations(u, a);
        history(made_at);
    }

    /// The positions at which the clusters were made; empty where there are none, and before the first evaluation.
    const Field<T>& history() const requires(in_registers) {
        for (const PairForce<T>& force : pairs_) {
            if (force.clusters()) return force.clusters()->made_at();
        }
        return no_history_;
    }
    void history(const Field<T>& made_at) requires(in_registers) {
        for (PairForce<T>& force : pairs_) {
            if (force.clusters()) force.clusters()->make_at(made_at);
        }
    }

    PotentialEnergy potential(const Field<T>& u);

    template <class F>
    void passing_pairs(const Field<T>& from, const Field<T>& to, F f) {
        const auto look = [&](std::size_t i, std::size_t j) {
            if (turned_round(separation(from, i, j), separation(to, i, j)))
                f(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
        };
        for (PairForce<T>& force : pairs_) {
            if (force.jumps_at_contact())
                force.each(particles_, from, [&](std::size_t i, std::size_t j, const Vec&, const T&) { look(i, j); });
        }
        for (const ComposedSpring& spring : terms().springs) look(spring.first, spring.second);
    }
    Vector<T> separation(const Field<T>& u, std::size_t i, std::size_t j) const {
        return particles_.separation(u, i, j);
    }
    Vector<T> difference(const Field<T>& u, std::size_t i, std::size_t j) const {
        return particles_.difference(u, i, j);
    }

    const Approaches& approaches() const {
        if (!approaches_) approaches_ = std::make_shared<const Approaches>(approaches_of(forces_.terms));
        return *approaches_;
    }
    bool has_local_fields() const { return fields_.has_local(); }
    double field_bound(const Field<T>& u, const Field<T>& v, const Field<T>& a, std::size_t i, double from,
                       double to) const {
        return moves(i) ? fields_.bound(particles_, {u, v, a}, i, from, to) : 0;
    }
    /// From now on exactly those pairs with a cut-off act on each other that are within it at these positions, those at
    /// it if they approach. In between the force is smooth. True if they are others than before.
    bool hold(const Field<T>& u, const Field<T>& v) {
        return hold(held_.acting(approaches(), v, [&](auto i, auto j) { return separation(u, i, j); }));
    }
    bool hold(ActingPairs acting) { return held_.hold(approaches(), std::move(acting), pairs_); }
    const ActingPairs& held() const { return held_.pairs(); }
    template <class F>
    void each_held(F f) const {
        held_.each(approaches(), f);
    }

    Coupling coupling() const { return steplab::coupling(forces_); }
    bool moves(std::size_t i) const { return particles_.moves(i); }
    Vector<T> external(std::size_t i) const {
        if (external_.empty() || !moves(i)) return {T(0), T(0), T(0)};
        return external_.size() == 1 ? external_.front() : external_[i];
    }

    /// Kinds: each spring, then each term of pairs, then each field.
    std::span<const ComposedFormula<T>> formulas() const { return formulas_; }
    template <class F>
    void each_interaction(const Field<T>& u, F f) {
        std::size_t kind = 0;
        for (const ComposedSpring& spring : terms().springs)
            f(std::size_t(spring.first), std::size_t(spring.second), kind++);
        for (PairForce<T>& force : pairs_) {
            force.each(particles_, u, [&](std::size_t i, std::size_t j, const Vec&, const T&) { f(i, j, kind); });
            ++kind;
        }
        for (const ComposedField& field : terms().fields) {
            for (const std::uint32_t i : field.particles) f(std::size_t(i), std::size_t(i), kind);
            ++kind;
        }
    }

    /// Of each particle in the unit of mass; empty where all are 1.
    const std::vector<T>& masses() const { return particles_.masses(); }
    T inverse_mass(std::size_t i) const { return particles_.inverse_mass(i); }
    PairProperties<T> properties(std::size_t i, std::size_t j, std::size_t kind) const {
        const std::size_t springs = terms().springs.size();
        if (kind < springs || kind - springs >= pairs_.size()) return particles_.properties(i, j);
        return pairs_[kind - springs].properties(particles_, i, j);
    }
    Vector<T> place(const Field<T>& u, std::size_t i) const { return particles_.place(u, i); }

    bool damped() const { return damping_.any(); }
    void damp(const Field<T>& u, Field<T>& v, T time) const { damping_.damp(particles_, u, v, time); }
    void add_damping(const Field<T>& u, const Field<T>& v, Field<T>& a) const { damping_.add(particles_, u, v, a); }
    template <class F>
    void each_damping(const Field<T>& u, F f) const {
        damping_.each(particles_, u, f);
    }

private:
    using Vec = Vector<T>;
    template <class N>
    friend class Composed;

    /// Of number types that are not summed in registers.
    struct None {
        explicit None(const ComposedParticles<T>&) {}
    };
    template <class Number, bool>
    struct RegistersOf {
        using Particles = None;
        using Rows = None;
    };
    template <class Number>
    struct RegistersOf<Number, true> {
        using Particles = ParticleRegisters<Number>;
        using Rows = SpringRows<Number>;
    };

    const Composition& terms() const { return particles_.terms(); }

    /// Clusters of all terms are made at the same positions.
    bool clusters_hold_at(const Field<T>& u) {
        for (PairForce<T>& force : pairs_) {
            if (force.clusters() && !force.clusters()->holds_at(u)) return false;
        }
        return true;
    }
    void follow(const Field<T>& u) {
        if (!clusters_hold_at(u)) history(u);
    }

    static Vec at(const Field<T>& field, std::size_t i) { return {field.x()[i], field.y()[i], field.z()[i]}; }
    static void set(Field<T>& field, std::size_t i, const Vec& vector) {
        field.x()[i] = vector.x;
        field.y()[i] = vector.y;
        field.z()[i] = vector.z;
    }
    void add_outside_and_springs(const Field<T>& u, Field<T>& a);
    void add_pairs(PairForce<T>& force, const Field<T>& u, Field<T>& a);
    double gravity_energy(std::size_t i, const Field<T>& u) const;

    ComposedForces forces_;
    ComposedParticles<T> particles_;
    ComposedDamping<T> damping_;
    std::vector<PairForce<T>> pairs_;
    ComposedFields<T> fields_;
    std::vector<ComposedFormula<T>> formulas_;
    std::vector<Vec> external_;
    std::shared_ptr<Team> team_;  ///< shared with copies, which are never used at the same time
    typename RegistersOf<T, in_registers>::Particles registers_;
    std::optional<typename RegistersOf<T, in_registers>::Rows> rows_;
    std::optional<ComposedSprings<T>> springs_;             ///< where there are no rows
    Field<T> no_history_, sums_;                            ///< sums_: scratch of each_acceleration()
    mutable std::shared_ptr<const Approaches> approaches_;  ///< once asked for
    HeldTerms<T> held_;
};

template <class T>
Composed<T>::Composed(const ComposedForces& forces)
    : forces_(forces),
      particles_(forces.terms),
      damping_(terms(), particles_),
      fields_(terms()),
      team_(in_registers ? std::make_shared<Team>(forces.threads) : nullptr),
      registers_(particles_) {
    if constexpr (in_registers) rows_ = SpringRows<T>::of(terms());
    if (!rows_) springs_.emplace(terms());
    const auto from = ComposedParticles<T>::vector;
    for (const ComposedSpring& spring : terms().springs)
        formulas_.push_back({from(spring.rest), SpringLaw<T>::of(spring, terms().mass)});
    for (const ComposedPairs& pairs : terms().pairs) pairs_.emplace_back(pairs, terms(), team_);
    for (const PairForce<T>& force : pairs_) formulas_.push_back({from({}), &force.potential()});
    for (std::size_t f = 0; f < terms().fields.size(); ++f) {
        const ComposedField& field = terms().fields[f];
        formulas_.push_back({from({0, field.along_y ? 1.0 : 0.0, field.along_z ? 1.0 : 0.0}), &fields_[f]});
    }
    for (const Vec3 acceleration : terms().accelerations) external_.push_back(from(acceleration));
}

template <class T>
void Composed<T>::accelerations(const Field<T>& u, Field<T>& a) {
    add_outside_and_springs(u, a);
    if constexpr (in_registers) follow(u);
    for (PairForce<T>& force : pairs_) add_pairs(force, u, a);
    fields_.add(particles_, u, a);
    for (std::size_t i = 0; i < terms().fixed.size(); ++i) {
        if (!moves(i)) set(a, i, {T(0), T(0), T(0)});
    }
}

template <class T>
template <class Sink>
void Composed<T>::each_acceleration(const Field<T>& u, Sink sink) requires(in_registers) {
    using N = Lanes<T>;
    const auto emit = [&](std::size_t r, const Vector<N>& a) __attribute__((always_inline)) {
        sink(r, registers_.held(r, a));
    };
    const bool springs_alone = rows_ && pairs_.empty() && fields_.empty();
    if (springs_alone) return rows_->each(u, registers_, *team_, emit);
    if (pairs_.size() == 1 && pairs_[0].clusters() && terms().springs.empty() && fields_.empty()) {
        follow(u);
        return pairs_[0].clusters()->accelerations(u, [&](std::size_t r, const Vector<N>& pulls) {
            emit(r, registers_.outside(r) + registers_.of_forces(r, pulls));
        });
    }
    if (sums_.count() != u.count()) sums_ = Field<T>(u.count());
    accelerations(u, sums_);
    const FieldLanes<const T> all(sums_);
    for (std::size_t r = 0; r < (u.count() + N::count - 1) / N::count; ++r) sink(r, all.get(r));
}

/// To what `a` is at first.
template <class T>
void Composed<T>::add_outside_and_springs(const Field<T>& u, Field<T>& a) {
    if constexpr (in_registers) {
        const auto set = [to = FieldLanes<T>(a)](std::size_t r, const auto& sum) { to.set(r, sum); };
        if (rows_) return rows_->each(u, registers_, *team_, set);
    }
    for (std::size_t i = 0; i < particles_.count(); ++i) set(a, i, external(i));
    springs_->add(particles_, u, a);
}

template <class T>
void Composed<T>::add_pairs(PairForce<T>& force, const Field<T>& u, Field<T>& a) {
    if (force.add_rows(u, a)) return;
    if constexpr (in_registers) {
        if (force.clusters()) {
            return force.clusters()->accelerations(u, [&, to = FieldLanes<T>(a)](std::size_t r, const auto& pulls) {
                to.set(r, to.get(r) + registers_.of_forces(r, pulls));
            });
        }
    }
    force.each_force(particles_, u, [&](std::size_t i, std::size_t j, const Vec& d, const T& factor) {
        const Vec push = factor * d;
        set(a, i, at(a, i) - inverse_mass(i) * push);
        set(a, j, at(a, j) + inverse_mass(j) * push);
    });
}

template <class T>
PotentialEnergy Composed<T>::potential(const Field<T>& u) {
    CompensatedSum value, magnitude, external_value;
    const auto count = [&](double energy) { value.add(energy), magnitude.add(std::abs(energy)); };
    const auto count_external = [&](double energy) { count(energy), external_value.add(energy); };
    for (std::size_t s = 0; s < terms().springs.size(); ++s) {
        const ComposedSpring& spring = terms().springs[s];
        if (moves(spring.first) || moves(spring.second))
            count(spring_energy(spring, formulas_[s], difference(u, spring.first, spring.second)));
    }
    for (PairForce<T>& force : pairs_) {
        force.each_energy(particles_, u, [&](const T& energy) { count(static_cast<double>(energy) * terms().mass); });
    }
    fields_.each_energy(particles_, u, [&](std::size_t i, const T& energy) {
        if (moves(i)) count_external(static_cast<double>(energy) * terms().mass);
    });
    for (std::size_t i = 0; i < particles_.count() && !external_.empty(); ++i) {
        if (moves(i)) count_external(gravity_energy(i, u));
    }
    return {value.value(), magnitude.value(), external_value.value()};
}

/// -m a.x, x the position.
template <class T>
double Composed<T>::gravity_energy(std::size_t i, const Field<T>& u) const {
    const Vec a = external(i);
    const Vec3 from = terms().reference.empty() ? Vec3{} : Vec3(terms().reference[i]);
    const auto product = [](T slope, double start, T shift) {
        return static_cast<double>(slope) * (start + static_cast<double>(shift));
    };
    const double mass = terms().mass * (terms().masses.empty() ? 1 : terms().masses[i]);
    return -mass * (product(a.x, from.x, u.x()[i]) + product(a.y, from.y, u.y()[i]) + product(a.z, from.z, u.z()[i]));
}

}  // namespace steplab
