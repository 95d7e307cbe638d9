#pragma once

#include "core/field.hpp"
#include "core/field_lanes.hpp"
#include "core/force_layout.hpp"
#include "core/stages.hpp"
#include "models/forces/forces.hpp"
#include "models/forces/held_pairs.hpp"
#include "models/forces/interactions.hpp"
#include "models/forces/morse_energies.hpp"
#include "models/forces/morse_pair.hpp"
#include "models/forces/neighbours.hpp"
#include "models/forces/pair_list.hpp"
#include "models/forces/pairs.hpp"
#include "models/periods.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

namespace steplab {

/// The Morse pulls of pairs by clusters (cluster_pulls.hpp).
template <class T>
struct CutMorsePulls {
    static constexpr std::size_t together = Lanes<T>::count;
    CutMorseConstants<T> constants;

    T cutoff() const { return constants.cutoff; }
    [[gnu::always_inline]] void make_factors(T* distances2, std::size_t count) const {
        using L = Lanes<T>;
        const auto morse = constants_as<L>(constants);
        const L cutoff2 = morse.cutoff * morse.cutoff, zero(T(0));
        for (std::size_t k = 0; k < count; k += L::count) {
            const L squares = L::load(distances2 + k);
            where(squares < cutoff2, morse_factor(morse, square_root(squares)), zero).store(distances2 + k);
        }
    }
};

/// The engine of NearPairForces. Sums in float and double go by clusters (pair_list.hpp); their last bits depend on the
/// positions at which the list was made, and so on the history of the run, see history(). Everything else, including
/// sums in other number types, goes through the neighbours of each particle in the order of their indices and depends
/// on positions alone. Lists extend a little beyond the cut-off and are renewed when a particle may have entered it.
template <class T>
class NearPairs {
    static constexpr bool by_clusters = std::is_same_v<T, float> || std::is_same_v<T, double>;

public:
    static constexpr ForceCapabilities capabilities{
        .hands_out = by_clusters, .history = by_clusters, .periodic = true, .range = true, .holds = true};

    explicit NearPairs(const NearPairForces& forces)
        : NearPairs(forces, by_clusters ? std::make_shared<Team>(forces.threads) : nullptr) {}

    NearPairs(const NearPairForces& forces, std::shared_ptr<Team> team)
        : forces_(forces),
          team_(std::move(team)),
          count_(forces.count),
          morse_(morse_constants<T>(forces)),
          periods_(forces.period),
          balance_(forces),
          sums_(forces.cutoff, forces.period, CutMorsePulls<T>{morse_}, team_),
          neighbours_(forces.cutoff, forces.period) {}

    /// The same forces in another number type.
    template <class N>
    NearPairs<N> in() const {
        return NearPairs<N>(forces_);
    }

    void accelerations(const Field<T>& u, Field<T>& a) {
        if (held_.any()) {
            held_.accelerations(
                morse_, [&](std::size_t i, std::size_t j) { return separation(u, i, j); }, a);
            balance_.take_off(a);
        } else if constexpr (by_clusters) {
            each_acceleration(u, [to = FieldLanes<T>(a)](std::size_t r, const auto& of) { to.set(r, of); });
        } else {
            sum_neighbours(u, a);
            balance_.take_off(a);
        }
    }

    /// The same, passed to a sink: calls sink(r, a) for every register r of particles, by several threads in parallel,
    /// when u is no longer read.
    template <class Sink>
    void each_acceleration(const Field<T>& u, Sink sink) requires(by_clusters) {
        if (!sums_.holds_at(u)) sums_.make_at(u);
        sums_.accelerations(
            u, [&](std::size_t r, const auto& a) __attribute__((always_inline)) { sink(r, balance_.taken_off(r, a)); });
    }

    /// The same for observers: leaves the list as it is. If the list is not valid here, a temporary one takes its
    /// place, and the old one is made again, as there is memory for one only.
    void uncounted_accelerations(const Field<T>& u, Field<T>& a) requires(by_clusters) {
        if (sums_.holds_at(u)) return accelerations(u, a);
        const Field<T> made_at = sums_.made_at();
        accelerations(u, a);
        sums_.make_at(made_at);
    }

    /// The positions at which the list of clusters was made, empty before the first evaluation: accelerations depend on
    /// these and on the current positions alone.
    const Field<T>& history() const requires(by_clusters) { return sums_.made_at(); }
    void history(const Field<T>& made_at) requires(by_clusters) { sums_.make_at(made_at); }

    PotentialEnergy potential(const Field<T>& u) const {
        MorseEnergies<T, CutMorseConstants<T>> energies(morse_);
        if constexpr (by_clusters) {
            sums_.each_near_distance2(u, [&](std::span<const double> near) {
                for (const double distance2 : near) energies.add(static_cast<T>(distance2));
            });
        } else {
            NearPairs(forces_, team_).each_near_pair(u, [&](std::size_t, std::size_t, const T& distance2) {
                energies.add(distance2);
            });
        }
        return energies.sum();
    }

    /// From now on exactly those pairs act on each other that are nearer than the cut-off at these positions, those at
    /// it if they approach. In between the force is smooth. True if they are others than before.
    bool hold(const Field<T>& u, const Field<T>& v) {
        ActingPairs acting;
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t j = i + 1; j < count_; ++j) acting.push_back(acts(u, v, i, j));
        }
        return hold(std::move(acting));
    }
    bool hold(ActingPairs acting) { return held_.hold(std::move(acting), count_); }
    const ActingPairs& held() const { return held_.acting(); }
    /// Calls f(i, j, cutoff, whether it acts) for every pair, held ones or not.
    template <class F>
    void each_held(F f) const {
        std::size_t pair = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t j = i + 1; j < count_; ++j) f(i, j, morse_.cutoff, bool(held_.acting()[pair++]));
        }
    }

    PairRange<T> range() const {
        PairRange<T> range = pair_range<T>(forces_, morse_);
        range.cutoff = morse_.cutoff;
        range.length = std::min(range.length, range.cutoff / T(2));
        range.period = static_cast<T>(forces_.period);
        return range;
    }

    /// Calls f(i, j), i < j, for pairs within reach that pass each other between two positions.
    template <class F>
    void passing_pairs(const Field<T>& from, const Field<T>& to, F f) {
        neighbours_.follow(from);
        for (std::size_t i = 0; i < count_; ++i) {
            for (const std::uint32_t j : neighbours_.of(i)) {
                if (j > i && turned_round(separation(from, i, j), separation(to, i, j)))
                    f(static_cast<std::uint32_t>(i), j);
            }
        }
    }
    /// The vector from particle i to the nearest image of particle j.
    Vector<T> separation(const Field<T>& u, std::size_t i, std::size_t j) const {
        const Vector<T> d{u.x()[j] - u.x()[i], u.y()[j] - u.y()[i], u.z()[j] - u.z()[i]};
        return {periods_.within(d.x), periods_.within(d.y), periods_.within(d.z)};
    }
    /// The argument of the formulas.
    Vector<T> difference(const Field<T>& u, std::size_t i, std::size_t j) const { return separation(u, i, j); }

    Coupling coupling() const { return steplab::coupling(forces_); }
    bool moves(std::size_t) const { return true; }
    Vector<T> external(std::size_t) const { return {T(0), T(0), T(0)}; }

    std::array<MorseFormula<T, CutMorseConstants>, 1> formulas() const { return {{{morse_}}}; }

    /// The pairs nearer than the cut-off, or those held.
    template <class F>
    void each_interaction(const Field<T>& u, F f) {
        if (held_.any()) return held_.each([&](std::size_t i, std::size_t j) { f(i, j, std::size_t(0)); });
        each_near_pair(u, [&](std::size_t i, std::size_t j, const T&) { f(i, j, std::size_t(0)); });
    }

private:
    struct NoClusters {
        NoClusters(double, double, const CutMorsePulls<T>&, const std::shared_ptr<Team>&) {}
    };
    template <bool, class Number>
    struct SumsOf {
        using Type = NoClusters;
    };
    template <class Number>
    struct SumsOf<true, Number> {
        using Type = PairList<Number, CutMorsePulls<Number>>;
    };

    bool acts(const Field<T>& u, const Field<T>& v, std::size_t i, std::size_t j) const {
        const Vector<T> w{v.x()[j] - v.x()[i], v.y()[j] - v.y()[i], v.z()[j] - v.z()[i]};
        return is_within(separation(u, i, j), w, morse_.cutoff);
    }

    /// Calls f(i, j, squared distance), i < j, for pairs nearer than the cut-off.
    template <class F>
    void each_near_pair(const Field<T>& u, F f) {
        neighbours_.follow(u);
        for (std::size_t i = 0; i < count_; ++i) {
            for (const std::uint32_t j : neighbours_.of(i)) {
                if (j < i) continue;
                const Vector<T> d = separation(u, i, j);
                const T distance2 = d.x * d.x + d.y * d.y + d.z * d.z;
                if (distance2 < morse_.cutoff * morse_.cutoff) f(i, std::size_t(j), distance2);
            }
        }
    }

    void sum_neighbours(const Field<T>& u, Field<T>& a) {
        neighbours_.follow(u);
        for (std::size_t i = 0; i < count_; ++i) {
            Vector<T> sum{T(0), T(0), T(0)};
            for (const std::uint32_t j : neighbours_.of(i)) add_pull(separation(u, j, i), sum);
            a.x()[i] = sum.x;
            a.y()[i] = sum.y;
            a.z()[i] = sum.z;
        }
    }

    void add_pull(const Vector<T>& d, Vector<T>& sum) const {
        const auto near = d.x * d.x + d.y * d.y + d.z * d.z < morse_.cutoff * morse_.cutoff;
        if (nowhere(near)) return;
        const Vector<T> pull = morse_pull(morse_, d);
        const T zero(T(0));
        sum = sum + Vector<T>{where(near, pull.x, zero), where(near, pull.y, zero), where(near, pull.z, zero)};
    }
    static bool nowhere(bool near) { return !near; }
    template <class Mask>
    static bool nowhere(const Mask& near) {
        return !any(near, T::count);
    }

    NearPairForces forces_;
    std::shared_ptr<Team> team_;
    std::size_t count_;
    CutMorseConstants<T> morse_;
    Periods<T> periods_;
    Balance<T> balance_;
    typename SumsOf<by_clusters, T>::Type sums_;
    Neighbours neighbours_;
    HeldPairs<T> held_;
};

}  // namespace steplab
