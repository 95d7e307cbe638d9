#pragma once

#include "core/lane_shuffles.hpp"
#include "core/lanes.hpp"
#include "core/vector.hpp"
#include "models/forces/morse_pair.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace steplab {

// Pulls between blocks of particles. The particles of a block are consecutive in memory, one per lane; the number of
// lanes is the same on every machine, so that no sum depends on its registers. T is float or double.

template <class T>
using BlockLanes = CacheLineLanes<T>;
template <class T>
inline constexpr std::size_t block_size = BlockLanes<T>::count;

/// Pointers to the components of a vector quantity of particles. Blocks start on a cache line.
template <class T>
struct Components {
    T *x, *y, *z;

    Components from(std::size_t particle) const { return {x + particle, y + particle, z + particle}; }
};

template <class T>
[[gnu::always_inline]] inline Vector<BlockLanes<std::remove_const_t<T>>> load_block(const Components<T>& from) {
    using N = BlockLanes<std::remove_const_t<T>>;
    return {N::load(from.x), N::load(from.y), N::load(from.z)};
}
template <class T>
[[gnu::always_inline]] inline void store_block(const Components<T>& to, const Vector<BlockLanes<T>>& block) {
    block.x.store(to.x);
    block.y.store(to.y);
    block.z.store(to.z);
}

/// For every particle of a block, the pulls of others in SIMD lanes, to be summed at the end.
template <class T>
class RowSums {
public:
    using N = BlockLanes<T>;

    RowSums() : x_{zeros()}, y_(x_), z_(x_) {}

    [[gnu::always_inline]] void add(std::size_t row, const Vector<N>& pulls) {
        x_[row] += pulls.x;
        y_[row] += pulls.y;
        z_[row] += pulls.z;
    }
    /// The sum of each row in its lane: the second half of a row is added to the first until one lane is left.
    Vector<N> sums() const { return {sums_of_rows(x_.data()), sums_of_rows(y_.data()), sums_of_rows(z_.data())}; }

private:
    using Rows = std::array<N, block_size<T>>;
    static Rows zeros() {
        Rows rows;
        rows.fill(N(T(0)));
        return rows;
    }

    alignas(64) Rows x_, y_, z_;
};

/// The Morse pulls between particles, block by block, some dozens of registers of pairs at a time: first their
/// distances, then the factors that turn distance vectors into pulls, then the pulls. A processor can overlap several
/// registers in each of these loops; in a single loop its out-of-order window is too short for that.
template <class T>
class BlockPulls {
    using N = BlockLanes<T>;
    static constexpr std::size_t width = block_size<T>, half = width / 2;

public:
    /// Positions and accelerations are those of `count` particles.
    BlockPulls(const MorseConstants<T>& morse, const Components<const T>& positions, const Components<T>& accelerations,
               std::size_t count)
        : morse_(morse), positions_(positions), accelerations_(accelerations), count_(count) {}

    /// Sets the accelerations to those caused within each block, with cyclic indices: P_s(i) is the pull at i by
    /// particle i + s, 0 if one of them does not exist. The acceleration of i is the sum from left to right of P_s(i) -
    /// P_s(i - s), s = 1, 2, ... up to half of the block, where it is P_s(i) alone. It is 0 for the padding.
    [[gnu::always_inline]] void pull_within() const {
        std::array<N, at_once * half> numbers;  // distances, then factors
        for (std::size_t from = 0; from < count_; from += at_once * width) {
            const std::size_t to = std::min(count_, from + at_once * width);
            std::size_t pairs = 0;
            for (std::size_t first = from; first < to; first += width, pairs += half)
                measure_circle(first, numbers.data() + pairs);
            make_factors(numbers.data(), pairs);
            pairs = 0;
            for (std::size_t first = from; first < to; first += width, pairs += half)
                set_circle(first, numbers.data() + pairs);
        }
    }

    /// Adds the pulls of all earlier blocks at the particles of the block that begins with `first`, in the order of
    /// RowSums, and subtracts them, particle by particle, from the accelerations of the earlier blocks.
    [[gnu::always_inline]] void pull_across(std::size_t first) const {
        const std::size_t rows = std::min(width, count_ - first);
        RowSums<T> sums;
        std::array<N, at_once * width> numbers;  // distances, then factors
        for (std::size_t from = 0; from < first; from += at_once * width) {
            const std::size_t to = std::min(first, from + at_once * width);
            std::size_t pairs = 0;
            for (std::size_t other = from; other < to; other += width, pairs += rows)
                measure_rows(first, rows, other, numbers.data() + pairs);
            make_factors(numbers.data(), pairs);
            pairs = 0;
            for (std::size_t other = from; other < to; other += width, pairs += rows)
                add_rows(first, rows, other, numbers.data() + pairs, sums);
        }
        const Components<T> own = accelerations_.from(first);
        store_block(own, load_block(own) + sums.sums());
    }

private:
    /// Number of blocks processed at a time.
    static constexpr std::size_t at_once = 4;
    using Shifts = std::make_index_sequence<half>;

    [[gnu::always_inline]] static N distance(const Vector<N>& d) {
        return square_root(d.x * d.x + d.y * d.y + d.z * d.z);
    }
    template <std::size_t Shift>
    [[gnu::always_inline]] static Vector<N> turned(const Vector<N>& block) {
        return {rotated<Shift>(block.x), rotated<Shift>(block.y), rotated<Shift>(block.z)};
    }
    /// Distance vectors from all particles of a block to one particle.
    [[gnu::always_inline]] static Vector<N> to_row(const Components<const T>& row, const Vector<N>& block) {
        return Vector<N>{N(*row.x), N(*row.y), N(*row.z)} - block;
    }

    /// Replaces `count` registers of distances by factors.
    [[gnu::always_inline]] void make_factors(N* numbers, std::size_t count) const {
        const MorseConstants<N> morse = constants_as<N>(morse_);
        for (std::size_t p = 0; p < count; ++p) numbers[p] = morse_factor(morse, numbers[p]);
    }

    [[gnu::always_inline]] void measure_circle(std::size_t first, N* distances) const {
        const Vector<N> block = load_block(positions_.from(first));
        [&]<std::size_t... S>(std::index_sequence<S...>) __attribute__((always_inline)) {
            ((distances[S] = distance(block - turned<S + 1>(block))), ...);
        }
        (Shifts{});
    }
    [[gnu::always_inline]] void set_circle(std::size_t first, const N* factors) const {
        const Vector<N> block = load_block(positions_.from(first));
        const Components<T> to = accelerations_.from(first);
        const N one(T(1));
        if (count_ - first >= width) {
            store_block(to, circle<true>(block, one, factors));
        } else {
            store_block(to, circle<false>(block, where(N::first(count_ - first), one, N(T(0))), factors));
        }
    }
    /// The sum within a block: of the particles for which `there` is 1, or of all.
    template <bool Full>
    [[gnu::always_inline]] static Vector<N> circle(const Vector<N>& block, const N& there, const N* factors) {
        const N zero(T(0));
        Vector<N> sum{zero, zero, zero};
        const auto add = [&]<std::size_t Shift>(std::integral_constant<std::size_t, Shift>)
            __attribute__((always_inline)) {
            Vector<N> pull = factors[Shift - 1] * (block - turned<Shift>(block));
            if constexpr (!Full) {
                const auto both = there * rotated<Shift>(there) > zero;
                pull = {where(both, pull.x, zero), where(both, pull.y, zero), where(both, pull.z, zero)};
            }
            if constexpr (Shift < half) {
                sum = sum + (pull - turned<width - Shift>(pull));
            } else {
                sum = sum + pull;
            }
        };
        [&]<std::size_t... S>(std::index_sequence<S...>) __attribute__((always_inline)) {
            (add(std::integral_constant<std::size_t, S + 1>{}), ...);
        }
        (Shifts{});
        return sum;
    }

    [[gnu::always_inline]] void measure_rows(std::size_t first, std::size_t rows, std::size_t other,
                                             N* distances) const {
        const Vector<N> block = load_block(positions_.from(other));
        for (std::size_t row = 0; row < rows; ++row)
            distances[row] = distance(to_row(positions_.from(first + row), block));
    }
    [[gnu::always_inline]] void add_rows(std::size_t first, std::size_t rows, std::size_t other, const N* factors,
                                         RowSums<T>& sums) const {
        const Vector<N> block = load_block(positions_.from(other));
        Vector<N> opposite = load_block(accelerations_.from(other));
        for (std::size_t row = 0; row < rows; ++row) {
            const Vector<N> pull = factors[row] * to_row(positions_.from(first + row), block);
            sums.add(row, pull);
            opposite = opposite - pull;
        }
        store_block(accelerations_.from(other), opposite);
    }

    MorseConstants<T> morse_;
    Components<const T> positions_;
    Components<T> accelerations_;
    std::size_t count_;
};

}  // namespace steplab
