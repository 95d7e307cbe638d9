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
    PairList(const NearPairForces& forces, const MorseConstants<T>& morse)
        : morse_(constants_as<N>(morse)),
          period_(forces.period),
          cutoff2_(static_cast<T>(forces.cutoff) * static_cast<T>(forces.cutoff)),
          allowed_(most_moved * skin * forces.cutoff),
          reach_((1 + skin) * forces.cutoff),
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
                const Vector<N> d = row.wraps ? distances<true>(row, k) : distances<false>(row, k);
                const N distance2 = d.x * d.x + d.y * d.y + d.z * d.z;
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

    void make_lists() {
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

    /// Those of another cluster that are within reach of the particles of a cluster.
    void find(std::uint32_t cluster, Clusters::Other other, std::array<std::size_t, Clusters::size>& count) {
        const bool itself = other.cluster() == cluster && other.image() == Clusters::own_image;
        const auto shift = [&](std::size_t axis) {
            return static_cast<T>(Clusters::periods(other.image(), axis)) * static_cast<T>(period_);
        };
        const Vector<T> image{shift(0), shift(1), shift(2)};
        const T most = static_cast<T>(reach_ * reach_);
        // in a small period a second image may be within reach; the nearest one is what counts
        const T half = period_ > 0 ? static_cast<T>(period_ / 2) : std::numeric_limits<T>::infinity();
        const auto nearest = [half](T d) { return d >= -half && d < half; };
        const T* const them = positions_.data() + other.cluster() * Clusters::size * stride;
        for (std::size_t i = 0; i < Clusters::size; ++i) {
            const T* const own = positions_.data() + (cluster * Clusters::size + i) * stride;
            const T x = own[0] - image.x, y = own[1] - image.y, z = own[2] - image.z;
            for (std::size_t j = itself ? i + 1 : 0; j < Clusters::size; ++j) {
                const T* const their = them + j * stride;
                const T dx = x - their[0], dy = y - their[1], dz = z - their[2];
                found_[i][count[i]] = static_cast<std::uint32_t>((other.cluster() * Clusters::size + j) * stride);
                count[i] += dx * dx + dy * dy + dz * dz < most && nearest(dx) && nearest(dy) && nearest(dz) ? 1 : 0;
            }
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

    /// From others to the particle of a row.
    template <bool Wraps>
    [[gnu::always_inline]] Vector<N> distances(const Row& row, std::uint32_t k) const {
        const T *const from = positions_.data(), *const own = from + row.first;
        const std::uint32_t* const others = list_.data() + k;
        const auto along = [=, this](std::size_t axis) {
            const N d = N(own[axis]) - N::each([=](std::size_t lane) { return from[others[lane] + axis]; });
            return Wraps ? d - periods_of_lanes_.nearest(d) : d;
        };
        return {along(0), along(1), along(2)};
    }

    /// Of all pairs of a row.
    template <bool Wraps>
    void add_pulls(const Row& row) {
        const N zero(T(0)), cutoff2(cutoff2_);
        Vector<N> sum{zero, zero, zero};
        for (std::uint32_t k = row.begin; k < row.end; k += N::count) {
            const Vector<N> d = distances<Wraps>(row, k);
            const auto near = d.x * d.x + d.y * d.y + d.z * d.z < cutoff2;
            Vector<N> pull = morse_pull(morse_, d);
            pull = {where(near, pull.x, zero), where(near, pull.y, zero), where(near, pull.z, zero)};
            sum = sum + pull;
            const std::uint32_t* const others = list_.data() + k;
            T* const sums = sums_.data();
            each_vector(pull.x, pull.y, pull.z, [=](std::size_t lane, const Four& of_lane) {
                T* const to = sums + others[lane];
                (Four::load(to) - of_lane).store(to);
            });
        }
        T* const to = sums_.data() + row.first;
        to[0] += total(sum.x);
        to[1] += total(sum.y);
        to[2] += total(sum.z);
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

    MorseConstants<N> morse_;
    double period_;
    T cutoff2_;
    double allowed_;
    double reach_;
    Periods<T> periods_;
    Periods<N> periods_of_lanes_;
    Clusters clusters_;
    Field<T> made_at_;
    Numbers positions_, sums_;
    std::vector<Row> rows_;
    std::vector<std::uint32_t> list_;
    std::array<std::vector<std::uint32_t>, Clusters::size> found_;  ///< memory of make_lists()
};

}  // namespace steplab
