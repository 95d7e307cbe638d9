#pragma once

#include "core/lane_shuffles.hpp"
#include "core/lanes.hpp"
#include "core/vector.hpp"
#include "models/morse_pair.hpp"

#include <array>
#include <cstddef>
#include <type_traits>

namespace steplab {

// Pulls between blocks of particles: those of a block are one after the other in memory, as many as lanes, which are
// the same number on every machine, so that no sum depends on its registers. T is float or double.

template <class T>
using BlockLanes = CacheLineLanes<T>;
template <class T>
inline constexpr std::size_t block_size = BlockLanes<T>::count;

/// Where the components of a quantity of particles are. Those of a block start on a cache line.
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

/// What a pair of particles needs roots for; they are taken while the pulls of other pairs are computed.
template <class N>
struct Measured {
    Vector<N> d;  ///< distance vector
    N distance;
};

/// The Morse pull in these two parts.
template <class T>
struct MorsePulls {
    MorseConstants<T> morse;

    template <class N>
    [[gnu::always_inline]] Measured<N> measured(const Vector<N>& d) const {
        return {d, square_root(d.x * d.x + d.y * d.y + d.z * d.z)};
    }
    template <class N>
    [[gnu::always_inline]] Vector<N> pull(const Measured<N>& pair) const {
        return morse_factor(constants_as<N>(morse), pair.distance) * pair.d;
    }
};

/// Of every particle of a block, the pulls of others side by side, to be added up at the end.
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
    /// The sum of each row in its lane: the first half of a row plus the second, lane by lane, until one is left.
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

namespace detail {

/// Several registers' worth of pairs at a time, so that they do not wait for each other: rows of a block, as many as
/// the machine has room for.
template <class T>
inline constexpr std::size_t rows_at_once = register_bytes == 64 ? 2 : 1;

template <class T, std::size_t Rows>
using RowLanes = RegisterLanes<T, Rows * block_size<T>>;

/// Of particles in rows, each with all of the block.
template <std::size_t Rows, class T>
[[gnu::always_inline]] inline RowLanes<T, Rows> differences(const T* rows, const BlockLanes<T>& block) {
    using Wide = RowLanes<T, Rows>;
    std::array<typename Wide::Register, Wide::parts> registers;
    for (std::size_t p = 0; p < Wide::parts; ++p)
        registers[p] = rows[p / BlockLanes<T>::parts] - block.registers()[p % BlockLanes<T>::parts];
    return Wide(registers);
}

template <class T, std::size_t Count>
[[gnu::always_inline]] inline BlockLanes<T> row_of(const RegisterLanes<T, Count>& rows, std::size_t row) {
    using N = BlockLanes<T>;
    std::array<typename N::Register, N::parts> registers;
    for (std::size_t p = 0; p < N::parts; ++p) registers[p] = rows.registers()[row * N::parts + p];
    return N(registers);
}
template <class T, std::size_t Count>
[[gnu::always_inline]] inline Vector<BlockLanes<T>> row_of(const Vector<RegisterLanes<T, Count>>& rows,
                                                           std::size_t row) {
    return {row_of(rows.x, row), row_of(rows.y, row), row_of(rows.z, row)};
}

/// pull_across() for rows from .. to, a multiple of Rows of them.
template <std::size_t Rows, class T, class Pulls>
[[gnu::always_inline]] inline void pull_rows(const Pulls& pulls, const Components<const T>& rows, std::size_t from,
                                             std::size_t to, const Vector<BlockLanes<T>>& block,
                                             Vector<BlockLanes<T>>& opposite, RowSums<T>& sums) {
    const auto measured = [&](std::size_t row) {
        return pulls.measured(Vector<RowLanes<T, Rows>>{differences<Rows>(rows.x + row, block.x),
                                                        differences<Rows>(rows.y + row, block.y),
                                                        differences<Rows>(rows.z + row, block.z)});
    };
    if (from == to) return;
    auto next = measured(from);
    for (std::size_t row = from; row < to; row += Rows) {
        const auto now = next;
        if (row + Rows < to) next = measured(row + Rows);
        const auto pull = pulls.pull(now);
        for (std::size_t r = 0; r < Rows; ++r) {
            sums.add(row + r, row_of(pull, r));
            opposite = opposite - row_of(pull, r);
        }
    }
}

}  // namespace detail

/// Adds the pulls of the particles of a block at each of `count` rows to the sums of the rows, and subtracts them, row
/// after row, from the accelerations of the block.
template <class T, class Pulls>
[[gnu::always_inline]] inline void pull_across(const Pulls& pulls, const Components<const T>& rows, std::size_t count,
                                               RowSums<T>& sums, const Components<const T>& block,
                                               const Components<T>& accelerations) {
    constexpr std::size_t at_once = detail::rows_at_once<T>;
    const Vector<BlockLanes<T>> others = load_block(block);
    Vector<BlockLanes<T>> opposite = load_block(accelerations);
    const std::size_t even = count / at_once * at_once;
    detail::pull_rows<at_once>(pulls, rows, 0, even, others, opposite, sums);
    if constexpr (at_once > 1) detail::pull_rows<1>(pulls, rows, even, count, others, opposite, sums);
    store_block(accelerations, opposite);
}

namespace detail {

/// The terms of pull_within() from `Shift` on.
template <std::size_t Shift, bool Full, class T, class Pulls>
[[gnu::always_inline]] inline void add_circles(const Pulls& pulls, const Vector<BlockLanes<T>>& block,
                                               const BlockLanes<T>& there, const Measured<BlockLanes<T>>& now,
                                               Vector<BlockLanes<T>>& sum) {
    using N = BlockLanes<T>;
    constexpr std::size_t half = block_size<T> / 2;
    const auto measured = [&]<std::size_t By>(std::integral_constant<std::size_t, By>) {
        return pulls.measured(block - Vector<N>{rotated<By>(block.x), rotated<By>(block.y), rotated<By>(block.z)});
    };
    Measured<N> next = now;
    if constexpr (Shift < half) next = measured(std::integral_constant<std::size_t, Shift + 1>{});
    Vector<N> pull = pulls.pull(now);
    if constexpr (!Full) {
        const auto both = there * rotated<Shift>(there) > N(T(0));
        pull = {where(both, pull.x, N(T(0))), where(both, pull.y, N(T(0))), where(both, pull.z, N(T(0)))};
    }
    if constexpr (Shift < half) {
        constexpr std::size_t back = block_size<T> - Shift;
        sum = sum + (pull - Vector<N>{rotated<back>(pull.x), rotated<back>(pull.y), rotated<back>(pull.z)});
        add_circles<Shift + 1, Full, T>(pulls, block, there, next, sum);
    } else {
        sum = sum + pull;
    }
}

}  // namespace detail

/// The accelerations of the first `count` particles of a block by each other, counted in a circle: P_s(i) is the pull
/// at i of the particle s further, 0 if one of them is not there. That of i is the sum from left to right of
/// P_s(i) - P_s(i - s), s = 1, 2, ... up to half of the circle, where it is P_s(i) alone. All others are 0.
template <class T, class Pulls>
[[gnu::always_inline]] inline Vector<BlockLanes<T>> pull_within(const Pulls& pulls, const Components<const T>& block,
                                                                std::size_t count) {
    using N = BlockLanes<T>;
    const Vector<N> u = load_block(block);
    const N there = where(N::first(count), N(T(1)), N(T(0)));
    Vector<N> sum{N(T(0)), N(T(0)), N(T(0))};
    const auto first = pulls.measured(u - Vector<N>{rotated<1>(u.x), rotated<1>(u.y), rotated<1>(u.z)});
    if (count == block_size<T>) {
        detail::add_circles<1, true, T>(pulls, u, there, first, sum);
    } else {
        detail::add_circles<1, false, T>(pulls, u, there, first, sum);
    }
    return sum;
}

}  // namespace steplab
