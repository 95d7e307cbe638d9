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
#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace steplab {

/// The sums of NearPairForces in float and double. Lists (cluster_lists.hpp) reach a skin further than the forces and
/// are made anew when a particle has gone half the skin: until then no pair can have come in. A list is gone through as
/// many pairs at a time as a cache line has numbers, on every machine: four particles side by side with two others
/// (float: four). Particles that are near each other in space are near in memory.
///
/// The order in which the pulls at a particle are added hangs on these lists, and they on where the particles were when
/// they were made: the pulls of slabs of clusters (Clusters::slabs()) side by side, first every other slab and then
/// those between. So the last bits of an acceleration hang on that too: made_at() is part of the state of a run. It
/// is kept and brought back with it, and whoever only looks does not renew the lists.
template <class T>
class PairList {
public:
    /// The team shares the work; its number of members changes no bit.
    PairList(const NearPairForces& forces, const CutMorseConstants<T>& morse, std::shared_ptr<Team> team)
        : morse_(constants_as<N>(morse)),
          period_(forces.period),
          cutoff2_(morse.cutoff * morse.cutoff),
          reach_((1 + skin) * forces.cutoff),
          allowed_(most_moved * skin * forces.cutoff),
          periods_(forces.period),
          team_(std::move(team)) {}

    /// True if the lists hold all pairs nearer than the cut-off.
    bool holds_at(const Field<T>& u) {
        if (made_at_.count() != u.count()) return false;
        std::atomic<bool> moved = false;
        team_->run([&](std::size_t member) {
            if (any_moved(u, part(member))) moved = true;
        });
        return !moved;
    }

    /// Where the particles were when the lists were made; empty before.
    const Field<T>& made_at() const { return made_at_; }
    /// Makes the lists of these positions.
    void make_at(const Field<T>& u) {
        made_at_ = {};  // should it fail, there are none
        positions_ = {};
        sums_ = {};
        const auto position = [&](std::size_t i) { return within_period(periods_, u, i); };
        lists_.make(u.count(), position, reach_, period_, *team_);
        positions_.assign(lists_.count(), std::numeric_limits<T>::quiet_NaN());
        sums_.resize(lists_.count());
        made_at_ = u;
    }

    /// Of the lists as they are.
    void accelerations(const Field<T>& u, Field<T>& a) {
        std::array<std::atomic<std::size_t>, 2> next{0, 1};
        team_->run([&](std::size_t member) {
            place(u, part(member));
            clear_sums(member);
            team_->meet();
            for (std::atomic<std::size_t>& slab : next) {
                for (std::size_t i = slab.fetch_add(2); i < lists_.slabs().size(); i = slab.fetch_add(2))
                    add_pulls(lists_.slabs()[i]);
                team_->meet();
            }
            if (member == 0) add_up_images();
            team_->meet();
            take_sums(a, part(member));
        });
    }

private:
    /// Of four particles and at least one other.
    using N = RegisterLanes<T, std::max<std::size_t>(detail::register_bytes / sizeof(T), 4)>;
    using Four = RegisterLanes<T, 4>;
    using Numbers = std::vector<T, CacheLineAllocator<T>>;

    using Row = typename ClusterLists<T>::Row;
    using Slab = typename ClusterLists<T>::Slab;

    static constexpr std::uint32_t size = ClusterLists<T>::size;
    static constexpr std::size_t stride = ClusterLists<T>::stride, numbers = ClusterLists<T>::numbers;
    /// Others of a group, on every machine, and those of them that go side by side.
    static constexpr std::uint32_t group = CacheLineLanes<T>::count / size, at_once = N::count / size;
    /// So many others, or particles, ahead of their turn their memory is fetched.
    static constexpr std::uint32_t ahead = 32;
    static_assert(ahead + group <= ClusterLists<T>::spare && 2 * group <= ClusterLists<T>::spare);
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

    using Part = Team::Part;
    /// Particles that are a member's.
    Part part(std::size_t member) const { return team_->part(made_at_.count(), member); }

    bool any_moved(const Field<T>& u, Part part) const {
        const T *const x = u.x() + part.begin, *const y = u.y() + part.begin, *const z = u.z() + part.begin;
        const T *const x0 = made_at_.x() + part.begin, *const y0 = made_at_.y() + part.begin,
                       *const z0 = made_at_.z() + part.begin;
        return any_of_all(part.end - part.begin, [=, most = static_cast<T>(allowed_ * allowed_)](std::size_t i) {
            const T dx = x[i] - x0[i], dy = y[i] - y0[i], dz = z[i] - z0[i];
            return !(dx * dx + dy * dy + dz * dz <= most);
        });
    }

    /// Places of no particle stay nowhere: out of everybody's reach.
    void place(const Field<T>& u, Part part) {
        const auto places = lists_.places();
        for (std::size_t i = part.begin; i < part.end; ++i) {
            __builtin_prefetch(positions_.data() + places[std::min(i + ahead, part.end - 1)] * stride, 1);
            T* const to = positions_.data() + places[i] * stride;
            const Vector<T> p = in_period(u, i);
            to[0] = p.x;
            to[1] = p.y;
            to[2] = p.z;
        }
    }

    void place_images(const Slab& slab) {
        T* to = positions_.data() + slab.first_image;
        for (const auto& [cluster, shift] : slab.images) {
            const std::array<T, stride> along{shift.x, shift.y, shift.z, T(0)};
            const Four by = Four::load_anywhere(along.data());
            const T* const from = positions_.data() + cluster * numbers;
            for (std::size_t k = 0; k < numbers; k += stride) (Four::load(from + k) + by).store(to + k);
            to += numbers;
        }
    }

    void clear_sums(std::size_t member) {
        const Part part = team_->part(sums_.size(), member);
        std::fill(sums_.data() + part.begin, sums_.data() + part.end, T(0));
    }

    /// What pulls at an image pulls at its particle.
    void add_up_images() {
        for (const Slab& slab : lists_.slabs()) {
            const T* from = sums_.data() + slab.first_image;
            for (const auto& image : slab.images) {
                T* const to = sums_.data() + image.cluster * numbers;
                for (std::size_t k = 0; k < numbers; k += stride)
                    (Four::load(to + k) + Four::load(from + k)).store(to + k);
                from += numbers;
            }
        }
    }

    void take_sums(Field<T>& a, Part part) const {
        const auto places = lists_.places();
        T *const x = a.x(), *const y = a.y(), *const z = a.z();
        for (std::size_t i = part.begin; i < part.end; ++i) {
            __builtin_prefetch(sums_.data() + places[std::min(i + ahead, part.end - 1)] * stride);
            const T* const sum = sums_.data() + places[i] * stride;
            x[i] = sum[0];
            y[i] = sum[1];
            z[i] = sum[2];
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

    [[gnu::always_inline]] Distances distances(const Vector<N>& own, const std::uint32_t* others) const {
        const T* const from = positions_.data();
        const Vector<N> d = own - repeated_vectors<T, N::count>([=](std::size_t j) { return from + others[j]; });
        const N square = d.x * d.x + d.y * d.y + d.z * d.z;
        return {d, square, square_root(square)};
    }

    /// From the particles of the cluster itself, the j-th of them on: no pair twice, none with itself.
    [[gnu::always_inline]] static Distances once(Distances pairs, std::uint32_t j) {
        const N place = N::each([](std::size_t lane) { return static_cast<T>(lane % size); });
        const N other = N::each([=](std::size_t lane) {
            const std::size_t which = lane / size;
            return static_cast<T>(j + which);
        });
        pairs.square = where(place < other, pairs.square, N(std::numeric_limits<T>::infinity()));
        return pairs;
    }

    /// Calls f(distances, others, part) for the pairs of a row that go side by side: the next ones of the list, a part
    /// of a group. Their roots are taken while f is busy with the pairs before.
    template <class F>
    [[gnu::always_inline]] void each_part(const Row& row, const std::uint32_t* list, F f) const {
        const Vector<N> own = four_of(row);
        N x, y, z, square, root;
        const auto look = [&](std::uint32_t k) __attribute__((always_inline)) {
            const Distances at = distances(own, list + k);
            x = at.d.x, y = at.d.y, z = at.d.z, square = at.square, root = at.root;
        };
        look(row.begin);
        for (std::uint32_t k = row.begin; k < row.begin + size; k += group) {
            for (std::uint32_t part = 0; part < group / at_once; ++part) {
                const std::uint32_t at = k + part * at_once;
                const Distances pairs = once({{x, y, z}, square, root}, at - row.begin);
                look(at + at_once);
                f(pairs, list + at, part);
            }
        }
        for (std::uint32_t k = row.begin + size; k < row.end; k += group) {
            fetch(list + k + ahead);
#pragma GCC unroll 4
            for (std::uint32_t part = 0; part < group / at_once; ++part) {
                const std::uint32_t at = k + part * at_once;
                const Distances pairs{{x, y, z}, square, root};
                look(at + at_once);
                f(pairs, list + at, part);
            }
        }
    }

    /// Tells the processor that the others of a group will be needed: who sorts by columns finds particles of the next
    /// ones in second-level caches or behind them.
    [[gnu::always_inline]] void fetch(const std::uint32_t* others) const {
        for (std::uint32_t k = 0; k < group; ++k) {
            __builtin_prefetch(positions_.data() + others[k]);
            __builtin_prefetch(sums_.data() + others[k], 1);
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

    /// Adds to the sums of the slab, of its images and of the next slab.
    void add_pulls(const Slab& slab) {
        place_images(slab);
        for (const Row& row : slab.rows) add_pulls(row, slab.list.data());
    }

    void add_pulls(const Row& row, const std::uint32_t* list) {
        Sums sums;
        sums.fill({N(T(0)), N(T(0)), N(T(0))});
        each_part(
            row, list,
            [&](const Distances& pairs, const std::uint32_t* others, std::uint32_t part)
                __attribute__((always_inline)) { add_pulls(pairs, others, sums[part]); });
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
    std::shared_ptr<Team> team_;  ///< of copies too, as they work in turns
    ClusterLists<T> lists_{group};
    Field<T> made_at_;
    Numbers positions_, sums_;
};

}  // namespace steplab
