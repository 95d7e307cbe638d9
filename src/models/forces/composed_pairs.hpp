#pragma once

#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/stages.hpp"
#include "core/vector.hpp"
#include "models/forces/composed_particles.hpp"
#include "models/forces/composed_rows.hpp"
#include "models/forces/neighbours.hpp"
#include "models/forces/pair_list.hpp"
#include "models/forces/pair_potential.hpp"
#include "models/forces/pair_sides.hpp"
#include "models/forces/potential_pulls.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace steplab {

/// One pair force of a composition: the potential and the pairs it joins.
template <class T>
class PairForce {
public:
    /// The team shares the sums by clusters.
    PairForce(const ComposedPairs& pairs, const Composition& of, const std::shared_ptr<Team>& team)
        : potential_(std::make_shared<const PairPotential<T>>(pairs, of.mass)),
          sides_(pairs, of.count),
          listed_(pairs.listed) {
        if (pairs.cutoff > 0) neighbours_.emplace(pairs.cutoff, of.box);
        takes_properties_ = steplab::takes_properties(pairs);
        jumps_at_contact_ = PairPotential<double>(pairs, of.mass).jumps_at_contact();
        if constexpr (in_batches) {
            rows_ = PairRows<T>::of(pairs, of);
            if (goes_by_clusters(pairs, of)) clusters_.emplace(pairs.cutoff, of.box.x, pulls(pairs.expression), team);
        }
    }

    const PairPotential<T>& potential() const { return *potential_; }
    bool jumps_at_contact() const { return jumps_at_contact_; }

    /// Of a pair, in the order in which the two sets are named.
    PairProperties<T> properties(const ComposedParticles<T>& particles, std::size_t i, std::size_t j) const {
        return sides_.turned(i, j) ? particles.properties(j, i) : particles.properties(i, j);
    }

    /// From now on these pairs act on each other and no others, as within the cut-off.
    void hold(std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs) { held_ = std::move(pairs); }

    /// Calls f(i, j, d, |d|^2), i < j, d from i to the nearest image of j, for the pairs that act on each other.
    template <class F>
    void each(const ComposedParticles<T>& particles, const Field<T>& u, F f) {
        if (!held_) return each_near(particles, u, f);
        for (const auto& [i, j] : *held_) {
            const Vector<T> d = particles.difference(u, i, j);
            f(std::size_t{i}, std::size_t{j}, d, d.x * d.x + d.y * d.y + d.z * d.z);
        }
    }
    /// The same for the pairs within the cut-off, held or not.
    template <class F>
    void each_near(const ComposedParticles<T>& particles, const Field<T>& u, F f) {
        const T cutoff2 = potential().cutoff() * potential().cutoff();
        each_candidate(particles, u, [&](std::size_t i, std::size_t j) {
            const Vector<T> d = particles.difference(u, i, j);
            const T distance2 = d.x * d.x + d.y * d.y + d.z * d.z;
            if (potential().cut() && none(distance2 < cutoff2)) return;
            f(i, j, d, distance2);
        });
    }

    /// The sums by clusters, where the force is within a cut-off and between all of many particles; else null.
    auto* clusters() { return clusters_ ? &*clusters_ : nullptr; }
    const auto* clusters() const { return clusters_ ? &*clusters_ : nullptr; }

    /// Adds all accelerations, where pairs are rows of a matrix; else false.
    bool add_rows(const Field<T>& u, Field<T>& a) const {
        if (!rows_) return false;
        potential().visit([&](const auto& potential) { rows_->add(potential, u, a); });
        return true;
    }

    /// Calls f(i, j, d, factor): the force on j, divided by the unit of mass, is factor times d, that on i the
    /// opposite.
    template <class F>
    void each_force(const ComposedParticles<T>& particles, const Field<T>& u, F f) {
        if constexpr (in_batches) {
            each_batch<false>(particles, u, f);
        } else {
            const T cutoff2 = potential().cutoff() * potential().cutoff();
            each(particles, u, [&](std::size_t i, std::size_t j, const Vector<T>& d, const T& distance2) {
                const T inside = where(distance2 > T(0), distance2, T(1));
                T factor = potential().factor(inside, properties(particles, i, j));
                factor = where(distance2 > T(0), factor, T(0));
                if (potential().cut() && !held_) factor = where(distance2 < cutoff2, factor, T(0));
                f(i, j, d, factor);
            });
        }
    }

    /// Calls f(energy) for every pair, the energy divided by the unit of mass.
    template <class F>
    void each_energy(const ComposedParticles<T>& particles, const Field<T>& u, F f) {
        if constexpr (in_batches) {
            if (clusters_ && particles.terms().fixed.empty()) return each_energy_of_near(u, f);
            each_batch<true>(particles, u,
                             [&](std::size_t, std::size_t, const Vector<T>&, const T& energy) { f(energy); });
        } else {
            each_near(particles, u, [&](std::size_t i, std::size_t j, const Vector<T>&, const T& distance2) {
                const PairProperties<T> pair = properties(particles, i, j);
                f(distance2 > T(0) ? potential().energy(distance2, pair) : potential().energy_of_coincident(pair));
            });
        }
    }

private:
    static constexpr bool in_batches = std::same_as<T, float> || std::same_as<T, double>;
    static constexpr std::size_t capacity = 64;
    /// Of fewer particles, neighbours in the order of their indices are as fast, and sums depend on positions alone.
    static constexpr std::size_t many = 200;

    /// Pairs that are computed together, register by register, or of an expression all at once.
    struct Batch {
        std::size_t count = 0;
        std::array<std::uint32_t, capacity> first, second;
        std::array<Vector<T>, capacity> d;
        alignas(64) std::array<T, capacity> distance2, result;
        alignas(64) std::array<T, capacity> first_mass{}, second_mass{}, first_charge{},
            second_charge{};  ///< where asked for
    };

    bool goes_by_clusters(const ComposedPairs& pairs, const Composition& of) const {
        const bool cubic = of.box.x == of.box.y && of.box.y == of.box.z;
        const bool all = pairs.second.empty() && pairs.first.size() == of.count;
        return pairs.cutoff > 0 && all && cubic && !takes_properties_ && of.count >= many;
    }
    PotentialPulls<T> pulls(const std::shared_ptr<const ExpressionForce>& expression) const {
        return {potential_, expression};
    }

    template <class Condition>
    static bool none(const Condition& condition) {
        if constexpr (HasLanes<T>)
            return !any(condition, T::count);
        else
            return !condition;
    }

    /// Calls f(i, j), i < j, for all pairs; of a force with a cut-off at least for those within it.
    template <class F>
    void each_candidate(const ComposedParticles<T>& particles, const Field<T>& u, F f) {
        if (!listed_.empty()) return each_listed(particles, f);
        const auto visit = [&](std::size_t i, std::size_t j) {
            if (particles.moves(i) || particles.moves(j)) f(i, j);
        };
        if (!neighbours_) return sides_.each(visit);
        neighbours_->follow(u);
        for (std::size_t i = 0; i < sides_.count(); ++i) {
            if (!sides_.has(i)) continue;
            const auto near = neighbours_->of(i);  // ascending
            for (auto j = std::upper_bound(near.begin(), near.end(), static_cast<std::uint32_t>(i)); j != near.end();
                 ++j) {
                if (sides_.joins(i, *j)) visit(i, *j);
            }
        }
    }

    template <class F>
    void each_listed(const ComposedParticles<T>& particles, F f) const {
        for (const auto& [i, j] : listed_) {
            if (particles.moves(i) || particles.moves(j)) f(std::size_t{i}, std::size_t{j});
        }
    }

    template <bool Energies, class F>
    void each_batch(const ComposedParticles<T>& particles, const Field<T>& u, F f) {
        Batch batch;
        const auto put = [&](std::size_t i, std::size_t j, const Vector<T>& d, const T& distance2) {
            const std::size_t k = batch.count++;
            batch.first[k] = static_cast<std::uint32_t>(i);
            batch.second[k] = static_cast<std::uint32_t>(j);
            batch.d[k] = d;
            batch.distance2[k] = distance2;
            if (batch.count == capacity) empty<Energies>(particles, batch, f);
        };
        if constexpr (Energies)
            each_near(particles, u, put);
        else
            each(particles, u, put);
        empty<Energies>(particles, batch, f);
    }

    template <bool Energies, class F>
    void empty(const ComposedParticles<T>& particles, Batch& batch, F f) {
        if (takes_properties_) keep_properties(particles, batch);
        potential().visit([&](const auto& potential) { compute<Energies>(potential, batch); });
        for (std::size_t k = 0; k < batch.count; ++k) {
            T result = batch.result[k];
            if (!(batch.distance2[k] > T(0)))
                result =
                    Energies
                        ? this->potential().energy_of_coincident(properties(particles, batch.first[k], batch.second[k]))
                        : T(0);
            f(batch.first[k], batch.second[k], batch.d[k], result);
        }
        batch.count = 0;
    }

    template <class F>
    void each_energy_of_near(const Field<T>& u, F f) const {
        Batch batch;
        const auto empty = [&] {
            potential().visit([&](const auto& potential) { compute<true>(potential, batch); });
            for (std::size_t k = 0; k < batch.count; ++k)
                f(batch.distance2[k] > T(0) ? batch.result[k] : potential().energy_of_coincident({}));
            batch.count = 0;
        };
        clusters_->each_near_distance2(u, [&](std::span<const double> near) {
            for (const double distance2 : near) {
                batch.distance2[batch.count++] = static_cast<T>(distance2);
                if (batch.count == capacity) empty();
            }
        });
        empty();
    }

    void keep_properties(const ComposedParticles<T>& particles, Batch& batch) const {
        for (std::size_t k = 0; k < batch.count; ++k) {
            const PairProperties<T> pair = properties(particles, batch.first[k], batch.second[k]);
            batch.first_mass[k] = pair.first_mass, batch.second_mass[k] = pair.second_mass;
            batch.first_charge[k] = pair.first_charge, batch.second_charge[k] = pair.second_charge;
        }
    }

    template <bool Energies, class Potential>
    static void compute(const Potential& potential, Batch& batch) {
        using N =
            std::conditional_t<std::same_as<Potential, ExpressionPotential<T>>, RegisterLanes<T, capacity>, Lanes<T>>;
        for (std::size_t k = batch.count; k < capacity; ++k) batch.distance2[k] = T(1);
        for (std::size_t k = 0; k < batch.count; k += N::count) {
            const auto at = [k](const std::array<T, capacity>& numbers) { return N::load(numbers.data() + k); };
            const PairProperties<N> pair{at(batch.first_mass), at(batch.second_mass), at(batch.first_charge),
                                         at(batch.second_charge)};
            const N result =
                Energies ? potential.energy(at(batch.distance2), pair) : potential.factor(at(batch.distance2), pair);
            result.store(batch.result.data() + k);
        }
    }

    std::shared_ptr<const PairPotential<T>> potential_;
    PairSides sides_;
    std::vector<std::array<std::uint32_t, 2>> listed_;  ///< the only pairs; empty: all
    std::optional<Neighbours> neighbours_;
    std::optional<std::vector<std::pair<std::uint32_t, std::uint32_t>>> held_;
    bool takes_properties_ = false;  ///< masses or charges
    bool jumps_at_contact_ = true;
    /// Of number types that are not summed so.
    struct None {
        template <class Potential>
        void add(const Potential&, const Field<T>&, Field<T>&) const {}
    };
    template <class Number, bool>
    struct SumsOf {
        using Rows = None;
        using Clusters = None;
    };
    template <class Number>
    struct SumsOf<Number, true> {
        using Rows = PairRows<Number>;
        using Clusters = PairList<Number, PotentialPulls<Number>>;
    };
    std::optional<typename SumsOf<T, in_batches>::Rows> rows_;
    std::optional<typename SumsOf<T, in_batches>::Clusters> clusters_;
};

}  // namespace steplab
