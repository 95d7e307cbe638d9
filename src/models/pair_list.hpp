#pragma once

#include "core/field.hpp"
#include "core/lane_vectors.hpp"
#include "core/lanes.hpp"
#include "models/clusters.hpp"
#include "models/forces.hpp"
#include "models/morse_pair.hpp"
#include "models/periods.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace steplab {

/// The sums of NearPairForces in float and double. Each particle has a list of others, which together hold every pair
/// once and reach a skin further than the forces; it is made anew when a particle has gone half the skin: until then no
/// pair can have come in. A list is gone through as many particles at a time as a cache line has numbers, on every
/// machine. Particles are numbered by the clusters they are in, so that those near in space are near in memory.
///
/// The order in which the pulls at a particle are added hangs on these lists, and they on where the particles were when
/// they were made. So the last bits of an acceleration hang on that too: made_at() is part of the state of a run. It
/// is kept and brought back with it, and whoever only looks does not renew the lists.
template <class T>
class PairList {
public:
    PairList(const NearPairForces& forces, const CutMorseConstants<T>& morse)
        : morse_(constants_as<N>(morse)),
          period_(forces.period),
          cutoff2_(morse.cutoff * morse.cutoff),
          reach_(reach_of(forces)),
          allowed_(most_moved * (reach_ - forces.cutoff)),
          periods_(forces.period > 0 ? forces.period : 1),
          periods_of_lanes_(forces.period > 0 ? forces.period : 1) {}

    /// True if the lists hold all pairs nearer than the cut-off.
    bool holds_at(const Field<T>& u) const {
        if (made_at_.count() != u.count()) return false;
        const T *const x = u.x(), *const y = u.y(), *const z = u.z();
        const T *const x0 = made_at_.x(), *const y0 = made_at_.y(), *const z0 = made_at_.z();
        return !any_of_all(u.count(), [=, most = static_cast<T>(allowed_ * allowed_)](std::size_t i) {
            const T dx = x[i] - x0[i], dy = y[i] - y0[i], dz = z[i] - z0[i];
            return !(dx * dx + dy * dy + dz * dz <= most);
        });
    }

    /// Where the particles were when the lists were made; empty before.
    const Field<T>& made_at() const { return made_at_; }
    /// Makes the lists of these positions.
    void make_at(const Field<T>& u) {
        made_at_ = u;
        if (u.count() == 0) return;
        Field<double> within(u.count());
        for (std::size_t i = 0; i < u.count(); ++i) {
            const Vector<T> p = in_period(u, i);
            within.set(i, {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
        }
        clusters_.make(within, reach_, period_);
        positions_.assign((clusters_.count() * Clusters::size + 1) * stride, std::numeric_limits<T>::quiet_NaN());
        place(u);
        make_lists();
    }

    /// Of the lists as they are.
    void accelerations(const Field<T>& u, Field<T>& a) {
        place(u);
        sums_.assign(positions_.size(), T(0));
        for (const Row& row : rows_) row.wraps ? add_pulls<true>(row) : add_pulls<false>(row);
        const auto places = clusters_.places();
        T *const x = a.x(), *const y = a.y(), *const z = a.z();
        for (std::size_t i = 0; i < places.size(); ++i) {
            const T* const sum = sums_.data() + places[i] * stride;
            x[i] = sum[0];
            y[i] = sum[1];
            z[i] = sum[2];
        }
    }

    /// Calls f(square of the distance) for all pairs nearer than the cut-off, where accelerations() was last asked for
    /// or the lists were made.
    template <class F>
    void each_distance2(F f) const {
        for (const Row& row : rows_) {
            for (std::uint32_t k = row.begin; k < row.end; k += N::count) {
                const N distance2 = (row.wraps ? distances<true>(row, k) : distances<false>(row, k)).square;
                for (std::size_t lane = 0; lane < N::count; ++lane) {
                    if (distance2[lane] < cutoff2_) f(distance2[lane]);
                }
            }
        }
    }

private:
    using N = CacheLineLanes<T>;
    using Four = RegisterLanes<T, 4>;
    using Numbers = std::vector<T, CacheLineAllocator<T>>;

    /// A particle and its others in the list.
    struct Row {
        std::uint32_t first;       ///< number of its place
        std::uint32_t begin, end;  ///< of the first numbers of the others' places, in the list
        bool wraps;                ///< others may be nearer in another image of space
    };

    /// Parts of the cut-off.
    static constexpr double skin = 0.15;
    /// Part of the skin that a particle may go: half of it, less what rounding may hide.
    static constexpr double most_moved = 0.48;

    /// Numbers of a particle: x, y, z and one that means nothing.
    static constexpr std::size_t stride = 4;

    Vector<T> in_period(const Field<T>& u, std::size_t i) const {
        const auto within = [&](const T* along, const T* made_at) {
            return period_ > 0 ? along[i] - periods_.nearest(made_at[i]) : along[i];
        };
        return {within(u.x(), made_at_.x()), within(u.y(), made_at_.y()), within(u.z(), made_at_.z())};
    }

    /// Places of no particle, and one behind all others, stay nowhere: out of everybody's reach.
    void place(const Field<T>& u) {
        const auto places = clusters_.places();
        for (std::size_t i = 0; i < places.size(); ++i) {
            T* const to = positions_.data() + places[i] * stride;
            const Vector<T> p = in_period(u, i);
            to[0] = p.x;
            to[1] = p.y;
            to[2] = p.z;
        }
    }

    /// x of the particles of a cluster, then y, then z.
    void gather_coordinates() {
        coordinates_.resize(clusters_.count() * 3 * Clusters::size);
        for (std::size_t place = 0; place < clusters_.count() * Clusters::size; ++place) {
            T* const to = coordinates_.data() + place / Clusters::size * 3 * Clusters::size + place % Clusters::size;
            for (std::size_t axis = 0; axis < 3; ++axis) to[axis * Clusters::size] = positions_[place * stride + axis];
        }
    }

    void make_lists() {
        gather_coordinates();
        rows_.clear();
        list_.clear();
        for (std::uint32_t cluster = 0; cluster < clusters_.count(); ++cluster) {
            const auto others = clusters_.others(cluster);
            const std::size_t most = (others.size() + 1) * Clusters::size;
            for (auto& row : found_) row.resize(std::max(row.size(), most));
            std::array<std::size_t, Clusters::size> count{};
            find(cluster, {cluster, Clusters::own_image}, count);
            bool wraps = false;
            for (const Clusters::Other other : others) {
                find(cluster, other, count);
                wraps = wraps || other.image() != Clusters::own_image;
            }
            for (std::size_t i = 0; i < Clusters::size; ++i) {
                if (count[i] > 0) append(cluster * Clusters::size + i, found_[i], count[i], wraps);
            }
        }
    }

    /// No further than half a period: of two images of a particle at most one is within reach.
    static double reach_of(const NearPairForces& forces) {
        const double reach = (1 + skin) * forces.cutoff;
        return forces.period > 0 ? std::min(reach, forces.period / 2) : reach;
    }

    /// Those of another cluster that are within reach of the particles of a cluster.
    void find(std::uint32_t cluster, Clusters::Other other, std::array<std::size_t, Clusters::size>& count) {
        const bool itself = other.cluster() == cluster && other.image() == Clusters::own_image;
        const auto shift = [&](std::size_t axis) {
            return static_cast<T>(Clusters::periods(other.image(), axis)) * static_cast<T>(period_);
        };
        const Vector<T> image{shift(0), shift(1), shift(2)};
        const Four most(static_cast<T>(reach_ * reach_));
        const T* const own = coordinates_.data() + cluster * 3 * Clusters::size;
        const T* const them = coordinates_.data() + other.cluster() * 3 * Clusters::size;
        const auto first = static_cast<std::uint32_t>(other.cluster() * Clusters::size * stride);
        const Four x = Four::load_anywhere(them), y = Four::load_anywhere(them + 4), z = Four::load_anywhere(them + 8);
        for (std::size_t i = 0; i < Clusters::size; ++i) {
            const Four dx = Four(own[i] - image.x) - x, dy = Four(own[i + 4] - image.y) - y,
                       dz = Four(own[i + 8] - image.z) - z;
            const auto near = dx * dx + dy * dy + dz * dz < most;
            std::uint32_t* const found = found_[i].data();
            std::size_t end = count[i];
            for (std::size_t j = 0; j < Clusters::size; ++j) {
                found[end] = first + static_cast<std::uint32_t>(j * stride);
                end += near[j] != 0 && (j > i || !itself) ? 1 : 0;
            }
            count[i] = end;
        }
    }

    /// Filled up with the place behind all others.
    void append(std::size_t place, const std::vector<std::uint32_t>& found, std::size_t count, bool wraps) {
        const auto begin = static_cast<std::uint32_t>(list_.size());
        const auto nowhere = static_cast<std::uint32_t>(positions_.size() - stride);
        list_.insert(list_.end(), found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count));
        list_.resize((list_.size() + N::count - 1) / N::count * N::count, nowhere);
        rows_.push_back(
            {static_cast<std::uint32_t>(place * stride), begin, static_cast<std::uint32_t>(list_.size()), wraps});
    }

    /// From others to the particle of a row, and how far that is.
    struct Distances {
        Vector<N> d;
        N square, root;
    };
    template <bool Wraps>
    [[gnu::always_inline]] Distances distances(const Row& row, std::uint32_t k) const {
        const T* const from = positions_.data();
        const std::uint32_t* const others = list_.data() + k;
        const Vector<N> there = gathered_vectors<N>([=](std::size_t lane) { return from + others[lane]; });
        const T* const own = from + row.first;
        Vector<N> d = Vector<N>{N(own[0]), N(own[1]), N(own[2])} - there;
        if constexpr (Wraps) {
            const auto nearest = [this](const N& component) { return periods_of_lanes_.nearest(component); };
            d = d - Vector<N>{nearest(d.x), nearest(d.y), nearest(d.z)};
        }
        const N square = d.x * d.x + d.y * d.y + d.z * d.z;
        return {d, square, square_root(square)};
    }

    /// Of all pairs of a row. Roots are taken while the pulls of the pairs before are computed.
    template <bool Wraps>
    void add_pulls(const Row& row) {
        const N zero(T(0)), cutoff2(cutoff2_);
        Vector<N> sum{zero, zero, zero};
        Distances next = distances<Wraps>(row, row.begin);
        for (std::uint32_t k = row.begin; k < row.end; k += N::count) {
            const Distances pairs = next;
            if (k + N::count < row.end) next = distances<Wraps>(row, k + N::count);
            const auto near = pairs.square < cutoff2;
            Vector<N> pull = morse_factor(morse_, pairs.root) * pairs.d;
            pull = {where(near, pull.x, zero), where(near, pull.y, zero), where(near, pull.z, zero)};
            sum = sum + pull;
            subtract(pull, list_.data() + k);
        }
        T* const to = sums_.data() + row.first;
        to[0] += total(sum.x);
        to[1] += total(sum.y);
        to[2] += total(sum.z);
    }

    [[gnu::always_inline]] void subtract(const Vector<N>& pull, const std::uint32_t* others) {
        T* const sums = sums_.data();
        each_vector(pull.x, pull.y, pull.z, [=](std::size_t lane, const Four& of_lane) {
            T* const to = sums + others[lane];
            (Four::load(to) - of_lane).store(to);
        });
    }

    /// The first half of the lanes plus the second, until one is left.
    template <std::size_t Count>
    [[gnu::always_inline]] static T total(const RegisterLanes<T, Count>& lanes) {
        if constexpr (Count > 4) {
            return total(halves_added(lanes));
        } else {
            return (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]);
        }
    }

    CutMorseConstants<N> morse_;
    double period_;
    T cutoff2_;
    double reach_;
    double allowed_;
    Periods<T> periods_;
    Periods<N> periods_of_lanes_;
    Clusters clusters_;
    Field<T> made_at_;
    Numbers positions_, sums_;
    std::vector<Row> rows_;
    std::vector<std::uint32_t> list_;
    // memory of make_lists()
    Numbers coordinates_;
    std::array<std::vector<std::uint32_t>, Clusters::size> found_;
};

}  // namespace steplab
