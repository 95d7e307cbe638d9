#pragma once

#include "core/compressed_lanes.hpp"
#include "core/field.hpp"
#include "core/lane_vectors.hpp"
#include "core/lanes.hpp"
#include "models/forces/cluster_lists.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace steplab {

/// The pulls of the pairs of a cluster's row (cluster_lists.hpp), in SIMD lanes, as many pairs at a time as a cache
/// line has numbers on every machine: four particles with two others (float: four). First the pairs within the cut-off
/// are found, then their factors are computed, which takes roots and divisions, then the pulls: a processor can overlap
/// several registers in each of these loops, and only one pair in four is near. T is float or double. Law is the force
/// of a pair: its cutoff(), and make_factors(distances2, count), which replaces squared distances by the factors that
/// turn a distance vector from another particle into the pull of that particle, 0 beyond the cut-off, and may use up to
/// `together` numbers behind them.
template <class T, class Law>
class ClusterPulls {
    using N = CacheLineLanes<T>;
    using Lists = ClusterLists<T>;

public:
    using Row = typename Lists::Row;
    /// Other particles per group of lanes.
    static constexpr std::uint32_t group = N::count / Lists::size;
    /// Each coordinate of a padding particle: its squared distance is infinite, beyond any cut-off, but no distance
    /// along an axis is (Clusters places no real particle there).
    static constexpr T nowhere = std::is_same_v<T, float> ? T(0x1p126F) : T(0x1p1021);

    explicit ClusterPulls(const Law& law) : law_(law) {}

    /// Reserves memory for rows of this length.
    void make_room(std::size_t others) {
        near_.resize(others / group + 1);
        squares_.resize(others * Lists::size + 2 * N::count + Law::together);
    }

    /// Adds the pulls at the particles of the cluster and at the others to `sums`. `positions` and `sums` are those of
    /// all particles; `list` is that of the row's slab.
    void add(const Row& row, const std::uint32_t* list, const T* positions, T* sums) {
        const Vector<N> own = four_of(positions + row.own);
        const auto [end, squares_end] = find_near(row, list, own, positions, sums);
        law_.make_factors(squares_.data(), static_cast<std::size_t>(squares_end - squares_.data()));
        const Vector<N> pulls = pull(end, list, own, positions, sums);
        add_to_four(pulls, sums + row.own);
    }

private:
    using Four = RegisterLanes<T, 4>;
    static constexpr std::uint32_t size = Lists::size;
    static constexpr std::size_t stride = Lists::stride;
    /// Memory is prefetched this number of particles ahead.
    static constexpr std::uint32_t ahead = 64;
    static_assert(ahead + group <= Lists::spare);

    /// Consecutive particles of the list, and which pairs with them are near.
    struct Group {
        std::uint32_t first;
        LaneSet near;
    };
    /// The end of what was found.
    struct End {
        Group* near;
        T* squares;
    };

    /// The positions of the particles of a cluster, repeated for each of the other particles in the lanes.
    static Vector<N> four_of(const T* from) {
        const auto along = [=](std::size_t axis) {
            return N::each([=](std::size_t lane) { return from[lane % size * stride + axis]; });
        };
        return {along(0), along(1), along(2)};
    }

    /// Distance vectors from the others to the particles of the cluster.
    [[gnu::always_inline]] static Vector<N> distances(const Vector<N>& own, const std::uint32_t* others,
                                                      const T* positions) {
        return own - repeated_vectors<T, N::count>([=](std::size_t j) __attribute__((always_inline)) {
                   return positions + others[j];
               });
    }
    [[gnu::always_inline]] static N square(const Vector<N>& d) { return d.x * d.x + d.y * d.y + d.z * d.z; }

    /// Squared distances within the cluster, to its particles from the j-th on: no pair twice, and no particle with
    /// itself.
    [[gnu::always_inline]] static N once(const N& squares, std::uint32_t j) {
        const N place = N::each([](std::size_t lane) { return static_cast<T>(lane % size); });
        const N other = N::each([=](std::size_t lane) {
            const std::size_t which = lane / size;
            return static_cast<T>(j + which);
        });
        return where(place < other, squares, N(std::numeric_limits<T>::infinity()));
    }

    /// Prefetches the others of a group: after sorting by columns, particles of the next columns are in the
    /// second-level cache or beyond.
    [[gnu::always_inline]] static void fetch(const std::uint32_t* others, const T* positions, T* sums) {
        for (std::uint32_t k = 0; k < group; ++k) {
            __builtin_prefetch(positions + others[k]);
            __builtin_prefetch(sums + others[k], 1);
        }
    }

    /// The groups that contain near pairs, and the squared distances of these pairs.
    [[gnu::always_inline]] End find_near(const Row& row, const std::uint32_t* list, const Vector<N>& own,
                                         const T* positions, T* sums) {
        const N cutoff2(law_.cutoff() * law_.cutoff());
        End end{near_.data(), squares_.data()};
        const auto emit = [&](std::uint32_t first, const N& squares) __attribute__((always_inline)) {
            const LaneSet near = lanes_below(squares, cutoff2);
            *end.near = {first, near};
            end.near += near != 0 ? 1 : 0;
            end.squares = store_compressed(near, squares, end.squares);
        };
        std::uint32_t k = row.begin;
        for (; k < row.begin + size; k += group)
            emit(k, once(square(distances(own, list + k, positions)), k - row.begin));
        for (const std::uint32_t last = row.end; k < last; k += group) {
            fetch(list + k + ahead, positions, sums);
            emit(k, square(distances(own, list + k, positions)));
        }
        return end;
    }

    /// Adds to the sums of the others and returns the pulls at the cluster's particles, separately for each other of a
    /// group.
    [[gnu::always_inline]] Vector<N> pull(const Group* end, const std::uint32_t* list, const Vector<N>& own,
                                          const T* positions, T* sums) const {
        const N zero(T(0));
        Vector<N> sum{zero, zero, zero};
        const T* factors = squares_.data();
        for (const Group* of = near_.data(); of != end; ++of) {
            const std::uint32_t* const others = list + of->first;
            const Vector<N> pulls = load_expanded<N>(of->near, factors) * distances(own, others, positions);
            sum = sum + pulls;
            each_sum_of_four(
                pulls, [=](std::size_t j, const Four& of_other) __attribute__((always_inline)) {
                    T* const to = sums + others[j];
                    (Four::load(to) - of_other).store(to);
                });
        }
        return sum;
    }

    static void add_to_four(const Vector<N>& pulls, T* to) {
        const Four x = halved(pulls.x), y = halved(pulls.y), z = halved(pulls.z);
        for (std::size_t i = 0; i < size; ++i, to += stride) {
            to[0] += x[i];
            to[1] += y[i];
            to[2] += z[i];
        }
    }
    /// Adds the second half of the lanes to the first until four are left.
    template <std::size_t Count>
    [[gnu::always_inline]] static Four halved(const RegisterLanes<T, Count>& lanes) {
        if constexpr (Count > 4) {
            return halved(halves_added(lanes));
        } else {
            return lanes;
        }
    }

    Law law_;
    std::vector<Group> near_;                        ///< of the current row
    std::vector<T, CacheLineAllocator<T>> squares_;  ///< later the factors
};

}  // namespace steplab
