#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/stages.hpp"
#include "core/sum.hpp"
#include "models/forces.hpp"
#include "models/interactions.hpp"
#include "models/morse_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

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

/// PairForces at work: every particle sums the pulls of all others in the order of their indices.
template <class T>
class Pairs {
public:
    explicit Pairs(const PairForces& forces)
        : forces_(forces), count_(forces.count), morse_(morse_constants<T>(forces)), balance_(forces) {}

    /// The same forces in another number type.
    template <class N>
    Pairs<N> in() const {
        return Pairs<N>(forces_);
    }

    void accelerations(const Field<T>& u, Field<T>& a) const {
        if constexpr (SideBySide<T>) {
            accelerate_pairs(u, a);
        } else {
            for (std::size_t begin = 0; begin < count_; begin += lanes) accelerate_lanes(u, a, begin);
        }
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
    /// Particles whose sums are kept in registers while one passes over all others.
    static constexpr std::size_t lanes = 16;
    using Lanes = std::array<T, lanes>;

    void accelerate_lanes(const Field<T>& u, Field<T>& a, std::size_t begin) const {
        alignas(64) Lanes sx{}, sy{}, sz{};
        const T *const x = u.x(), *const y = u.y(), *const z = u.z();
        const MorseConstants<T> morse = morse_;
        for (std::size_t j = 0; j < count_; ++j) {
            for (std::size_t l = 0; l < lanes; ++l) {
                const std::size_t i = begin + l;
                const Vector<T> pull = morse_pull(morse, Vector<T>{x[i] - x[j], y[i] - y[j], z[i] - z[j]});
                sx[l] += pull.x;
                sy[l] += pull.y;
                sz[l] += pull.z;
            }
        }
        const std::size_t used = std::min(lanes, count_ - begin);
        std::copy_n(sx.data(), used, a.x() + begin);
        std::copy_n(sy.data(), used, a.y() + begin);
        std::copy_n(sz.data(), used, a.z() + begin);
    }

    /// Numbers that fill registers by themselves: every pair once. The order of each particle's sum is the same.
    void accelerate_pairs(const Field<T>& u, Field<T>& a) const {
        std::fill(a.flat().begin(), a.flat().end(), T(0));
        const T *const x = u.x(), *const y = u.y(), *const z = u.z();
        T *const ax = a.x(), *const ay = a.y(), *const az = a.z();
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t j = i + 1; j < count_; ++j) {
                const Vector<T> pull = morse_pull(morse_, Vector<T>{x[i] - x[j], y[i] - y[j], z[i] - z[j]});
                ax[i] += pull.x;
                ay[i] += pull.y;
                az[i] += pull.z;
                ax[j] -= pull.x;
                ay[j] -= pull.y;
                az[j] -= pull.z;
            }
        }
    }

    PairForces forces_;
    std::size_t count_;
    MorseConstants<T> morse_;
    Balance<T> balance_;
};

}  // namespace steplab
