#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "core/stages.hpp"
#include "models/forces/forces.hpp"
#include "models/forces/interactions.hpp"
#include "models/forces/morse_energies.hpp"
#include "models/forces/morse_pair.hpp"
#include "models/forces/pair_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace steplab {

template <class T>
MorseConstants<T> morse_constants(const PairForces& forces) {
    const T depth = static_cast<T>(forces.depth);
    const T b = square_root(static_cast<T>(forces.k) / (T(2) * depth));
    return {depth, b, static_cast<T>(forces.r0), T(2) * b * depth / static_cast<T>(forces.mass)};
}

template <class T>
PairRange<T> pair_range(const PairForces& forces, const MorseConstants<T>& morse) {
    return {morse.r0, T(1) / morse.b, static_cast<T>(4 * forces.depth / forces.mass)};
}

template <class T>
CutMorseConstants<T> morse_constants(const NearPairForces& forces) {
    const MorseConstants<T> uncut = morse_constants<T>(static_cast<const PairForces&>(forces));
    const T cutoff = static_cast<T>(forces.cutoff);
    const T pull = morse_factor(uncut, cutoff) * cutoff;
    return {uncut, cutoff, pull, morse_energy(uncut, cutoff), -(static_cast<T>(forces.mass) * pull)};
}

/// PairForces::balance in the number type of an engine.
template <class T>
class Balance {
public:
    explicit Balance(const PairForces& forces) {
        if (forces.balance) accelerations_ = converted<T>(*forces.balance);
    }

    void take_off(Field<T>& a) const {
        if (accelerations_.count() == 0) return;
        T* const out = a.flat().data();
        const T* const balance = accelerations_.flat().data();
        elementwise(a.flat().size(), [=](std::size_t k) { out[k] -= balance[k]; });
    }

    /// The same for the accelerations of the r-th register of particles.
    [[gnu::always_inline]] Vector<Lanes<T>> taken_off(std::size_t r, const Vector<Lanes<T>>& a) const {
        return accelerations_.count() == 0 ? a : a - FieldLanes<const T>(accelerations_).get(r);
    }

private:
    Field<T> accelerations_;
};

/// The engine of PairForces. Every pair is computed once, in consecutive blocks of 8 particles (float: 16), whatever
/// the registers of the machine. The acceleration of i is the cyclic sum within its own block (see BlockPulls), plus
/// the pulls of all particles of earlier blocks: first those at the same place in their blocks in order, then the
/// places by halves (see RowSums); minus its pulls at the particles of later blocks in order.
template <class T>
class Pairs {
public:
    static constexpr ForceCapabilities capabilities{.range = true};

    explicit Pairs(const PairForces& forces)
        : forces_(forces), count_(forces.count), morse_(morse_constants<T>(forces)), balance_(forces) {}

    /// The same forces in another number type.
    template <class N>
    Pairs<N> in() const {
        return Pairs<N>(forces_);
    }

    /// Calls f(number) for the constants that depend on the scene's parameters.
    template <class Self, class F>
    static void each_constant(Self& self, F f) {
        f(self.morse_.depth), f(self.morse_.b), f(self.morse_.r0), f(self.morse_.strength), f(self.morse_.b2);
    }

    void accelerations(const Field<T>& u, Field<T>& a) {
        if constexpr (detail::InRegisters<T>) {
            pull_blocks({u.x(), u.y(), u.z()}, {a.x(), a.y(), a.z()});
        } else {
            std::fill(a.flat().begin(), a.flat().end(), T(0));
            pull_one_by_one(u, a);
        }
        balance_.take_off(a);
    }

    PotentialEnergy potential(const Field<T>& u) const {
        MorseEnergies<T, MorseConstants<T>> energies(morse_);
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t j = i + 1; j < count_; ++j) {
                const T dx = u.x()[i] - u.x()[j], dy = u.y()[i] - u.y()[j], dz = u.z()[i] - u.z()[j];
                energies.add(dx * dx + dy * dy + dz * dz);
            }
        }
        return energies.sum();
    }

    /// Calls f(i, j), i < j, for pairs that pass each other between two positions.
    template <class F>
    void passing_pairs(const Field<T>& from, const Field<T>& to, F f) const {
        for (std::size_t i = 0; i + 1 < count_; ++i) {
            const auto turned = [&](std::size_t j) {
                return turned_round(separation(from, i, i + 1 + j), separation(to, i, i + 1 + j));
            };
            if (!any_of_all(count_ - i - 1, turned)) continue;
            for (std::size_t j = 0; j < count_ - i - 1; ++j) {
                if (turned(j)) f(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1 + j));
            }
        }
    }
    /// The vector from particle i to particle j.
    Vector<T> separation(const Field<T>& u, std::size_t i, std::size_t j) const {
        return {u.x()[j] - u.x()[i], u.y()[j] - u.y()[i], u.z()[j] - u.z()[i]};
    }

    PairRange<T> range() const { return pair_range(forces_, morse_); }

    Coupling coupling() const { return {Coupling::Kind::all, count_}; }
    bool moves(std::size_t) const { return true; }
    Vector<T> external(std::size_t) const { return {T(0), T(0), T(0)}; }

    std::array<MorseFormula<T>, 1> formulas() const { return {{{morse_}}}; }

    template <class F>
    void each_interaction(const Field<T>&, F f) const {
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t j = i + 1; j < count_; ++j) f(i, j, std::size_t(0));
        }
    }

private:
    /// Particles of a block: for a number type with lanes the same as for a single number.
    static constexpr std::size_t width = [] {
        if constexpr (HasLanes<T>) return block_size<std::remove_cvref_t<decltype(std::declval<T>()[0])>>;
        return std::max<std::size_t>(block_size<T>, 8);
    }();

    /// A separate function, so that the constants are in registers.
    [[gnu::noinline]] void pull_blocks(const Components<const T>& u, const Components<T>& a) const {
        BlockPulls<T> pulls(morse_, u, a, count_);
        pulls.pull_within();
        for (std::size_t first = width; first < count_; first += width) pulls.pull_across(first);
    }

    /// The same sums for number types without registers.
    void pull_one_by_one(const Field<T>& u, Field<T>& a) const {
        for (std::size_t first = 0; first < count_; first += width) {
            const std::size_t size = std::min(width, count_ - first);
            pull_in_circle(u, a, first, size);
            for (std::size_t i = first; i < first + size; ++i) {
                std::array<Vec, width> row;
                row.fill({T(0), T(0), T(0)});
                for (std::size_t j = 0; j < first; ++j) {
                    const Vec pull = morse_pull(morse_, separation(u, j, i));
                    row[j % width] = row[j % width] + pull;
                    set(a, j, at(a, j) - pull);
                }
                for (std::size_t half = width / 2; half > 0; half /= 2) {
                    for (std::size_t place = 0; place < half; ++place) row[place] = row[place] + row[place + half];
                }
                set(a, i, at(a, i) + row[0]);
            }
        }
    }

    /// The pulls within `size` particles from `first` on.
    void pull_in_circle(const Field<T>& u, Field<T>& a, std::size_t first, std::size_t size) const {
        for (std::size_t ahead = 1; ahead <= width / 2; ++ahead) {
            std::array<Vec, width> pulls;
            pulls.fill({T(0), T(0), T(0)});
            for (std::size_t place = 0; place < size; ++place) {
                const std::size_t other = (place + ahead) % width;
                if (other < size) pulls[place] = morse_pull(morse_, separation(u, first + other, first + place));
            }
            for (std::size_t place = 0; place < size; ++place) {
                const std::size_t behind = (place + width - ahead) % width;
                const Vec change = ahead < width / 2 ? pulls[place] - pulls[behind] : pulls[place];
                set(a, first + place, at(a, first + place) + change);
            }
        }
    }

    using Vec = Vector<T>;
    static inline const Vec zero{T(0), T(0), T(0)};
    static Vec at(const Field<T>& field, std::size_t i) { return {field.x()[i], field.y()[i], field.z()[i]}; }
    static void set(Field<T>& field, std::size_t i, const Vec& vector) {
        field.x()[i] = vector.x;
        field.y()[i] = vector.y;
        field.z()[i] = vector.z;
    }

    PairForces forces_;
    std::size_t count_;
    MorseConstants<T> morse_;
    Balance<T> balance_;
};

}  // namespace steplab
