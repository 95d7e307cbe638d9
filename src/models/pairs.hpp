#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/sum.hpp"
#include "models/forces.hpp"
#include "models/interactions.hpp"
#include "models/morse_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace steplab {

template <class T>
MorseConstants<T> morse_constants(const PairForces& forces) {
    const T depth = static_cast<T>(forces.depth);
    const T b = square_root(static_cast<T>(forces.k) / (T(2) * depth));
    return {depth, b, static_cast<T>(forces.r0), T(2) * b * depth / static_cast<T>(forces.mass)};
}

/// PairForces::balance at work, in the number type of an engine.
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

private:
    Field<T> accelerations_;
};

/// PairForces at work. Every pair is computed once, the pairs of all particles i with i + s, counted in a circle, side
/// by side: P_s(i) is the pull of i + s at i. The acceleration of i is (P_1(i) - P_1(i - 1)) + (P_2(i) - P_2(i - 2)) +
/// ... up to half of the circle, from left to right; of an even number of particles the last term is P_(n/2)(i) alone.
template <class T>
class Pairs {
public:
    explicit Pairs(const PairForces& forces)
        : forces_(forces),
          count_(forces.count),
          morse_(morse_constants<T>(forces)),
          lead_(padded(count_ / 2 + width)),
          stride_(lead_ + padded(count_) + width),
          positions_(3 * stride_, T(0)),
          pulls_{positions_, positions_},
          balance_(forces) {}

    /// The same forces in another number type.
    template <class N>
    Pairs<N> in() const {
        return Pairs<N>(forces_);
    }

    /// Calls f(number) for the numbers that the scene's parameters make.
    template <class Self, class F>
    static void each_constant(Self& self, F f) {
        f(self.morse_.depth), f(self.morse_.b), f(self.morse_.r0), f(self.morse_.strength);
    }

    void accelerations(const Field<T>& u, Field<T>& a) {
        repeat_positions(u);
        std::fill(a.flat().begin(), a.flat().end(), T(0));
        for (std::size_t ahead = 1; ahead <= count_ / 2; ++ahead) {
            compute_pulls(ahead);
            if (ahead > 1) add_pulls(a, ahead - 1);  // one behind: what has just been stored is slow to load in parts
        }
        if (count_ > 1) add_pulls(a, count_ / 2);
        balance_.take_off(a);
    }

    PotentialEnergy potential(const Field<T>& u) const {
        CompensatedSum value, magnitude;
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t j = i + 1; j < count_; ++j) {
                const T dx = u.x()[i] - u.x()[j], dy = u.y()[i] - u.y()[j], dz = u.z()[i] - u.z()[j];
                const double energy =
                    static_cast<double>(morse_energy(morse_, square_root(dx * dx + dy * dy + dz * dz)));
                value.add(energy);
                magnitude.add(std::abs(energy));
            }
        }
        return {value.value(), magnitude.value(), 0};
    }

    /// Calls f(i, j), i < j, for pairs that turn round between two positions.
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
    using N = Lanes<T>;
    using Vec = Vector<N>;
    using Numbers = std::vector<T, CacheLineAllocator<T>>;
    static constexpr std::size_t width = N::count;
    static std::size_t padded(std::size_t n) { return (n + width - 1) / width * width; }

    /// One component, of 3, of numbers that are there for all particles and for some of them once more: behind
    /// the last one in positions_, in front of the first one in pulls_.
    T* component(Numbers& numbers, std::size_t c) { return numbers.data() + c * stride_; }

    void repeat_positions(const Field<T>& u) {
        const std::array<const T*, 3> from{u.x(), u.y(), u.z()};
        for (std::size_t c = 0; c < 3; ++c) {
            T* const to = component(positions_, c);
            for (std::size_t k = 0; k < count_; k += width) N::load(from[c] + k).store(to + k);
            for (std::size_t k = 0; k < lead_; k += width) N::load(from[c] + k).store_anywhere(to + count_ + k);
        }
    }

    /// Of every particle by the one that is so far ahead of it. By itself, so that its constants are in registers.
    [[gnu::noinline]] void compute_pulls(std::size_t ahead) {
        const T *const x = component(positions_, 0), *const y = component(positions_, 1),
                       *const z = component(positions_, 2);
        const MorseConstants<N> morse{N(morse_.depth), N(morse_.b), N(morse_.r0), N(morse_.strength)};
        Numbers& pulls = pulls_[ahead % 2];
        T *const px = component(pulls, 0) + lead_, *const py = component(pulls, 1) + lead_,
                 *const pz = component(pulls, 2) + lead_;
        const std::size_t count = count_;
        // from behind, so that the numbers of the first particles are the last to be stored
        for (std::size_t i = padded(count); i > 0;) {
            i -= width;
            const auto difference = [&](const T* along) {
                return N::load(along + i) - N::load_anywhere(along + i + ahead);
            };
            const Vec pull = morse_pull(morse, Vec{difference(x), difference(y), difference(z)});
            if (i + width + ahead > count) {
                pull.x.store_anywhere(px + i - count);
                pull.y.store_anywhere(py + i - count);
                pull.z.store_anywhere(pz + i - count);
            }
            pull.x.store(px + i);
            pull.y.store(py + i);
            pull.z.store(pz + i);
        }
    }

    /// Each pull to its particle and its opposite to the other one; opposite particles have both been computed.
    void add_pulls(Field<T>& a, std::size_t ahead) {
        const std::array<T*, 3> sums{a.x(), a.y(), a.z()};
        const bool opposite = 2 * ahead == count_;
        for (std::size_t c = 0; c < 3; ++c) {
            const T* const pull = component(pulls_[ahead % 2], c) + lead_;
            for (std::size_t i = 0; i < count_; i += width) {
                N change = N::load(pull + i);
                if (!opposite) change = change - N::load_anywhere(pull + i - ahead);
                if (i + width > count_) change = where(N::first(count_ - i), change, N(T(0)));
                (N::load(sums[c] + i) + change).store(sums[c] + i);
            }
        }
    }

    PairForces forces_;
    std::size_t count_;
    MorseConstants<T> morse_;
    std::size_t lead_;    ///< particles that are there twice
    std::size_t stride_;  ///< from one component to the next
    Numbers positions_;
    std::array<Numbers, 2> pulls_;  ///< of the last two distances of indices
    Balance<T> balance_;
};

}  // namespace steplab
