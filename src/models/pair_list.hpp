#pragma once

#include "core/field.hpp"
#include "core/lane_vectors.hpp"
#include "core/lanes.hpp"
#include "models/cluster_lists.hpp"
#include "models/forces.hpp"
#include "models/morse_pair.hpp"
#include "models/periods.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace steplab {

/// The sums of NearPairForces in float and double. Lists (cluster_lists.hpp) reach a skin further than the forces and
/// are made anew when a particle has gone half the skin: until then no pair can have come in. A list is gone through as
/// many pairs at a time as a cache line has numbers, on every machine: four particles side by side with two others
/// (float: four). Particles that are near each other in space are near in memory.
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
          reach_((1 + skin) * forces.cutoff),
          allowed_(most_moved * skin * forces.cutoff),
          periods_(forces.period > 0 ? forces.period : 1) {}

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
        positions_ = {};
        lists_.make(std::move(within), reach_, period_);
        positions_.assign(lists_.count(), std::numeric_limits<T>::quiet_NaN());
        place(u);
    }

    /// Of the lists as they are.
    void accelerations(const Field<T>& u, Field<T>& a) {
        place(u);
        sums_.assign(positions_.size(), T(0));
        for (const Row& row : lists_.rows()) add_pulls(row);
        add_up_images();
        const auto places = lists_.places();
        T *const x = a.x(), *const y = a.y(), *const z = a.z();
        for (std::size_t i = 0; i < places.size(); ++i) {
            const T* const sum = sums_.data() + places[i] * stride;
            x[i] = sum[0];
            y[i] = sum[1];
            z[i] = sum[2];
        }
    }

private:
    /// Of four particles and at least one other.
    using N = RegisterLanes<T, std::max<std::size_t>(detail::register_bytes / sizeof(T), 4)>;
    using Four = RegisterLanes<T, 4>;
    using Numbers = std::vector<T, CacheLineAllocator<T>>;

    using Row = typename ClusterLists<T>::Row;

    static constexpr std::uint32_t size = ClusterLists<T>::size;
    static constexpr std::size_t stride = ClusterLists<T>::stride, numbers = ClusterLists<T>::numbers;
    /// Others of a group, on every machine, and those of them that go side by side.
    static constexpr std::uint32_t group = CacheLineLanes<T>::count / size, at_once = N::count / size;
    /// Of the parts of a group.
    using Sums = std::array<Vector<N>, group / at_once>;

    /// Parts of the cut-off.
    static constexpr double skin = 0.15;
    /// Part of the skin that a particle may go: half of it, less what rounding may hide.
    static constexpr double most_moved = 0.48;

    Vector<T> in_period(const Field<T>& u, std::size_t i) const {
        const auto within = [&](const T* along, const T* made_at) {
            return period_ > 0 ? along[i] - periods_.nearest(made_at[i]) : along[i];
        };
        return {within(u.x(), made_at_.x()), within(u.y(), made_at_.y()), within(u.z(), made_at_.z())};
    }

    /// Places of no particle stay nowhere: out of everybody's reach.
    void place(const Field<T>& u) {
        const auto places = lists_.places();
        for (std::size_t i = 0; i < places.size(); ++i) {
            T* const to = positions_.data() + places[i] * stride;
            const Vector<T> p = in_period(u, i);
            to[0] = p.x;
            to[1] = p.y;
            to[2] = p.z;
        }
        T* to = positions_.data() + lists_.first_image();
        for (const auto& [cluster, shift] : lists_.images()) {
            const std::array<T, stride> along{shift.x, shift.y, shift.z, T(0)};
            const Four by = Four::load_anywhere(along.data());
            const T* const from = positions_.data() + cluster * numbers;
            for (std::size_t k = 0; k < numbers; k += stride) (Four::load(from + k) + by).store(to + k);
            to += numbers;
        }
    }

    /// What pulls at an image pulls at its particle.
    void add_up_images() {
        const T* from = sums_.data() + lists_.first_image();
        for (const auto& image : lists_.images()) {
            T* const to = sums_.data() + image.cluster * numbers;
            for (std::size_t k = 0; k < numbers; k += stride) (Four::load(to + k) + Four::load(from + k)).store(to + k);
            from += numbers;
        }
    }

    /// From others to the particles of a cluster, and how far that is.
    struct Distances {
        Vector<N> d;
        N square, root;
    };

    /// The positions of the particles of a cluster, again for each of the others that go side by side.
    Vector<N> four_of(const Row& row) const {
        const T* const from = positions_.data() + row.own;
        const auto along = [=](std::size_t axis) {
            return N::each([=](std::size_t lane) { return from[lane % size * stride + axis]; });
        };
        return {along(0), along(1), along(2)};
    }

    [[gnu::always_inline]] Distances distances(const Vector<N>& own, std::uint32_t k) const {
        const T* const from = positions_.data();
        const std::uint32_t* const others = lists_.list() + k;
        const Vector<N> d = own - repeated_vectors<T, N::count>([=](std::size_t j) { return from + others[j]; });
        const N square = d.x * d.x + d.y * d.y + d.z * d.z;
        return {d, square, square_root(square)};
    }

    /// From the particles of the cluster itself, the j-th of them on: no pair twice, none with itself.
    [[gnu::always_inline]] static Distances once(Distances pairs, std::uint32_t j) {
        const N place = N::each([](std::size_t lane) { return static_cast<T>(lane % size); });
        const N other = N::each([=](std::size_t lane) { return static_cast<T>(j + lane / size); });
        pairs.square = where(place < other, pairs.square, N(std::numeric_limits<T>::infinity()));
        return pairs;
    }

    /// Calls f(distances, k, part) for the pairs of a row that go side by side: others k, k + 1, ... of the list, a
    /// part of a group. Their roots are taken while f is busy with the pairs before.
    template <class F>
    [[gnu::always_inline]] void each_part(const Row& row, F f) const {
        const Vector<N> own = four_of(row);
        N x, y, z, square, root;
        const auto look = [&](std::uint32_t k) __attribute__((always_inline)) {
            const Distances at = distances(own, k);
            x = at.d.x, y = at.d.y, z = at.d.z, square = at.square, root = at.root;
        };
        look(row.begin);
        for (std::uint32_t k = row.begin; k < row.begin + size; k += group) {
            for (std::uint32_t part = 0; part < group / at_once; ++part) {
                const std::uint32_t at = k + part * at_once;
                const Distances pairs = once({{x, y, z}, square, root}, at - row.begin);
                look(at + at_once);
                f(pairs, at, part);
            }
        }
        for (std::uint32_t k = row.begin + size; k < row.end; k += group) {
#pragma GCC unroll 4
            for (std::uint32_t part = 0; part < group / at_once; ++part) {
                const std::uint32_t at = k + part * at_once;
                const Distances pairs{{x, y, z}, square, root};
                look(at + at_once);
                f(pairs, at, part);
            }
        }
    }

    /// To `sum` those of these pairs at the particles of the cluster, and their opposites to the others'.
    [[gnu::always_inline]] void add_pulls(const Distances& pairs, const std::uint32_t* others, Vector<N>& sum) {
        const N zero(T(0));
        const auto near = pairs.square < N(cutoff2_);
        Vector<N> pull = morse_factor(morse_, pairs.root) * pairs.d;
        pull = {where(near, pull.x, zero), where(near, pull.y, zero), where(near, pull.z, zero)};
        sum = sum + pull;
        each_sum_of_four(pull, [sums = sums_.data(), others](std::size_t j, const Four& of_other) {
            T* const to = sums + others[j];
            (Four::load(to) - of_other).store(to);
        });
    }

    void add_pulls(const Row& row) {
        Sums sums;
        sums.fill({N(T(0)), N(T(0)), N(T(0))});
        each_part(
            row, [&, list = lists_.list() ](const Distances& pairs, std::uint32_t k, std::uint32_t part)
                     __attribute__((always_inline)) { add_pulls(pairs, list + k, sums[part]); });
        for (std::size_t half = sums.size() / 2; half > 0; half /= 2) {
            for (std::size_t part = 0; part < half; ++part) sums[part] = sums[part] + sums[part + half];
        }
        const Four x = halved(sums[0].x), y = halved(sums[0].y), z = halved(sums[0].z);
        T* to = sums_.data() + row.own;
        for (std::size_t i = 0; i < size; ++i, to += stride) {
            to[0] += x[i];
            to[1] += y[i];
            to[2] += z[i];
        }
    }

    /// The first half of the lanes plus the second, until four are left.
    template <std::size_t Count>
    [[gnu::always_inline]] static Four halved(const RegisterLanes<T, Count>& lanes) {
        if constexpr (Count > 4) {
            return halved(halves_added(lanes));
        } else {
            return lanes;
        }
    }

    CutMorseConstants<N> morse_;
    double period_;
    T cutoff2_;
    double reach_;
    double allowed_;
    Periods<T> periods_;
    ClusterLists<T> lists_{group};
    Field<T> made_at_;
    Numbers positions_, sums_;
};

}  // namespace steplab
