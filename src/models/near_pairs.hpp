#pragma once

#include "core/field.hpp"
#include "core/stages.hpp"
#include "core/sum.hpp"
#include "models/forces.hpp"
#include "models/interactions.hpp"
#include "models/morse_pair.hpp"
#include "models/neighbours.hpp"
#include "models/pairs.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace steplab {

/// NearPairForces at work: every particle sums the pulls of those nearer than the cut-off in the order of their
/// indices. The list of neighbours reaches a little further and is renewed when somebody may have come in; as pairs
/// beyond the cut-off add nothing, the sums do not depend on when that was.
template <class T>
class NearPairs {
public:
    explicit NearPairs(const NearPairForces& forces)
        : forces_(forces),
          count_(forces.count),
          morse_(morse_constants<T>(forces)),
          cutoff_(static_cast<T>(forces.cutoff)),
          shift_(morse_energy(morse_, cutoff_)),
          balance_(forces),
          neighbours_(forces.cutoff) {}

    /// The same forces in another number type.
    template <class N>
    NearPairs<N> in() const {
        return NearPairs<N>(forces_);
    }

    void accelerations(const Field<T>& u, Field<T>& a) {
        neighbours_.follow(u);
        for (std::size_t i = 0; i < count_; ++i) {
            Vector<T> sum{T(0), T(0), T(0)};
            const auto others = neighbours_.of(i);
            for (std::size_t k = 0; k < others.size(); k += width)
                add_pulls(u, i, others.subspan(k, std::min(width, others.size() - k)), sum);
            a.x()[i] = sum.x;
            a.y()[i] = sum.y;
            a.z()[i] = sum.z;
        }
        balance_.take_off(a);
    }

    /// V(r) - V(cut-off), so that the energy does not jump where pairs come in.
    PotentialEnergy potential(const Field<T>& u) {
        neighbours_.follow(u);
        CompensatedSum value, magnitude;
        for (std::size_t i = 0; i < count_; ++i) {
            for (const std::uint32_t j : neighbours_.of(i)) {
                if (j < i) continue;
                const T dx = u.x()[i] - u.x()[j], dy = u.y()[i] - u.y()[j], dz = u.z()[i] - u.z()[j];
                const T distance2 = dx * dx + dy * dy + dz * dz;
                if (!(distance2 < cutoff_ * cutoff_)) continue;
                const double energy = static_cast<double>(morse_energy(morse_, square_root(distance2)) - shift_);
                value.add(energy);
                magnitude.add(energy < 0 ? -energy : energy);
            }
        }
        return {value.value(), magnitude.value(), 0};
    }

    /// Calls f(i, j), i < j, for pairs within reach that turn round between two positions.
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
    /// The vector from particle i to particle j.
    Vector<T> separation(const Field<T>& u, std::size_t i, std::size_t j) const {
        return {u.x()[j] - u.x()[i], u.y()[j] - u.y()[i], u.z()[j] - u.z()[i]};
    }

    Coupling coupling() const { return {Coupling::Kind::near, count_}; }
    bool moves(std::size_t) const { return true; }
    Vector<T> external(std::size_t) const { return {T(0), T(0), T(0)}; }

    std::array<MorseFormula<T>, 1> formulas() const { return {{{morse_}}}; }

    /// The pairs nearer than the cut-off.
    template <class F>
    void each_interaction(const Field<T>& u, F f) {
        neighbours_.follow(u);
        for (std::size_t i = 0; i < count_; ++i) {
            for (const std::uint32_t j : neighbours_.of(i)) {
                if (j < i) continue;
                const T dx = u.x()[i] - u.x()[j], dy = u.y()[i] - u.y()[j], dz = u.z()[i] - u.z()[j];
                if (dx * dx + dy * dy + dz * dz < cutoff_ * cutoff_) f(i, std::size_t(j), std::size_t(0));
            }
        }
    }

private:
    using N = Lanes<T>;
    static constexpr std::size_t width = N::count;

    static bool nowhere(bool near) { return !near; }
    template <class Mask>
    static bool nowhere(const Mask& near) {
        return !any(near, T::count);
    }

    /// The pulls of others at particle i, no more of them than lanes, computed side by side and added one by one.
    [[gnu::always_inline]] void add_pulls(const Field<T>& u, std::size_t i, std::span<const std::uint32_t> others,
                                          Vector<T>& sum) const {
        const auto from_others = [&](const T* along) {
            return N(along[i]) -
                   N::each([&](std::size_t lane) { return along[others[std::min(lane, others.size() - 1)]]; });
        };
        const Vector<N> d{from_others(u.x()), from_others(u.y()), from_others(u.z())};
        const auto near = d.x * d.x + d.y * d.y + d.z * d.z < N(cutoff_ * cutoff_);
        if constexpr (width == 1) {
            if (nowhere(near)) return;
        }
        const auto morse = constants_as<N>(morse_);
        const Vector<N> pull = morse_pull(morse, d);
        const N zero(T(0)), x = where(near, pull.x, zero), y = where(near, pull.y, zero), z = where(near, pull.z, zero);
        for (std::size_t lane = 0; lane < others.size(); ++lane) {
            sum.x += x[lane];
            sum.y += y[lane];
            sum.z += z[lane];
        }
    }

    NearPairForces forces_;
    std::size_t count_;
    MorseConstants<T> morse_;
    T cutoff_;
    T shift_;
    Balance<T> balance_;
    Neighbours neighbours_;
};

}  // namespace steplab
