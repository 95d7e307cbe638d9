#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/field_lanes.hpp"
#include "core/lanes.hpp"
#include "core/team.hpp"
#include "models/forces/cluster_lists.hpp"
#include "models/forces/cluster_pulls.hpp"
#include "models/periods.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace steplab {

/// The sums of a force within a cut-off between all particles, in float and double. Lists (cluster_lists.hpp) extend
/// beyond the cut-off by a skin and are renewed when a particle has moved by half the skin: until then no new pair can
/// be within the cut-off. Particles that are near in space are near in memory.
///
/// The order in which the pulls at a particle are added depends on these lists, and so on the positions at which they
/// were made: slabs of clusters (Clusters::slabs()) are summed in parallel, first every other slab and then those
/// between. The last bits of an acceleration depend on it too: made_at() is therefore part of the state of a run and is
/// saved and restored with it, and observers do not renew the lists.
/// Law: see cluster_pulls.hpp.
template <class T, class Law>
class PairList {
public:
    /// In a cubic box of this side; 0: none. The team shares the work; results do not depend on its size.
    PairList(double cutoff, double period, const Law& law, std::shared_ptr<Team> team)
        : cutoff_(cutoff),
          period_(period),
          reach_((1 + skin) * cutoff),
          allowed_(most_moved * skin * cutoff),
          periods_(period),
          team_(std::move(team)),
          pulls_(team_->members(), Pulls(law)) {}

    /// True if the lists hold all pairs nearer than the cut-off.
    bool holds_at(const Field<T>& u) {
        if (made_at_.count() != u.count()) return false;
        std::atomic<bool> moved = false;
        team_->run([&](std::size_t member) {
            if (any_moved(u, part(member))) moved = true;
        });
        return !moved;
    }

    /// The positions at which the lists were made; empty before.
    const Field<T>& made_at() const { return made_at_; }
    /// Makes the lists for these positions.
    void make_at(const Field<T>& u) {
        made_at_ = {};  // if making them fails, there are none
        positions_.clear();
        sums_.clear();
        const auto position = [&](std::size_t i) { return within_period(periods_, u, i); };
        lists_.make(u.count(), position, reach_, period_, *team_);
        for (Pulls& pulls : pulls_) pulls.make_room(lists_.longest());
        positions_.assign(lists_.count(), Pulls::nowhere);
        sums_.resize(lists_.count());
        made_at_ = u;
    }

    /// Calls f with the squared distances of all pairs nearer than the cut-off, some at a time, whatever the lists
    /// hold.
    template <class F>
    void each_near_distance2(const Field<T>& u, F f) const {
        const auto position = [&](std::size_t i) { return within_period(periods_, u, i); };
        steplab::each_near_distance2(u.count(), position, cutoff_, period_, *team_, f);
    }

    /// With the lists as they are: calls sink(r, a) with the accelerations of every register r of particles, by all
    /// members of the team in parallel, when u is no longer read.
    template <class Sink>
    void accelerations(const Field<T>& u, Sink sink) {
        std::array<std::atomic<std::size_t>, 2> next{0, 1};
        team_->run([&](std::size_t member) {
            place(u, registers(member));
            clear_sums(member);
            team_->meet();
            for (std::atomic<std::size_t>& slab : next) {
                for (std::size_t i = slab.fetch_add(2); i < lists_.slabs().size(); i = slab.fetch_add(2))
                    add_pulls(lists_.slabs()[i], pulls_[member]);
                team_->meet();
            }
            add_up_images(member);
            team_->meet();
            take_sums(registers(member), sink);
        });
    }

private:
    using N = Lanes<T>;
    using Four = RegisterLanes<T, 4>;
    using Pulls = ClusterPulls<T, Law>;
    using Numbers = std::vector<T, CacheLineAllocator<T>>;

    using Row = typename ClusterLists<T>::Row;
    using Slab = typename ClusterLists<T>::Slab;

    static constexpr std::size_t stride = ClusterLists<T>::stride, numbers = ClusterLists<T>::numbers;
    /// Memory is prefetched this number of particles ahead.
    static constexpr std::size_t ahead = 32;
    static_assert(ahead + 2 * N::count <= Clusters::spare);

    /// The skin, relative to the cut-off.
    static constexpr double skin = 0.15;
    /// Allowed motion of a particle, relative to the skin: half of it minus a margin for rounding.
    static constexpr double most_moved = 0.48;

    using Part = Team::Part;
    /// The particles of a member.
    Part part(std::size_t member) const { return team_->part(made_at_.count(), member); }
    /// Its registers of particles; the last one may extend beyond the last particle (ClusterLists::places()).
    Part registers(std::size_t member) const {
        return team_->part((made_at_.count() + N::count - 1) / N::count, member);
    }

    bool any_moved(const Field<T>& u, Part part) const {
        const T *const x = u.x() + part.begin, *const y = u.y() + part.begin, *const z = u.z() + part.begin;
        const T *const x0 = made_at_.x() + part.begin, *const y0 = made_at_.y() + part.begin,
                       *const z0 = made_at_.z() + part.begin;
        return any_of_all(part.end - part.begin, [=, most = static_cast<T>(allowed_ * allowed_)](std::size_t i) {
            const T dx = x[i] - x0[i], dy = y[i] - y0[i], dz = z[i] - z0[i];
            return !(dx * dx + dy * dy + dz * dz <= most);
        });
    }

    /// Padding particles keep their position out of reach of all others.
    void place(const Field<T>& u, Part registers) {
        const FieldLanes<const T> moved(u), made_at(made_at_);
        for (std::size_t r = registers.begin; r < registers.end; ++r) {
            Vector<N> p = moved.get(r);
            if (period_ > 0) p = p - periods(made_at.get(r));
            const std::uint32_t* const places = lists_.places().data() + r * N::count;
            for (std::size_t lane = 0; lane < N::count; ++lane) {
                __builtin_prefetch(positions_.data() + places[lane + ahead] * stride, 1);
                T* const to = positions_.data() + places[lane] * stride;
                to[0] = p.x[lane];
                to[1] = p.y[lane];
                to[2] = p.z[lane];
            }
        }
    }
    [[gnu::always_inline]] Vector<N> periods(const Vector<N>& at) const {
        const Periods<N> of(period_);
        return {of.nearest(at.x), of.nearest(at.y), of.nearest(at.z)};
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

    /// Adds the pulls at images to their particles, for a member's clusters.
    void add_up_images(std::size_t member) {
        const Part clusters = team_->part(lists_.clusters(), member);
        for (const Slab& slab : lists_.slabs()) {
            const T* from = sums_.data() + slab.first_image;
            for (const auto& image : slab.images) {
                if (image.cluster >= clusters.begin && image.cluster < clusters.end) {
                    T* const to = sums_.data() + image.cluster * numbers;
                    for (std::size_t k = 0; k < numbers; k += stride)
                        (Four::load(to + k) + Four::load(from + k)).store(to + k);
                }
                from += numbers;
            }
        }
    }

    template <class Sink>
    void take_sums(Part registers, Sink sink) const {
        for (std::size_t r = registers.begin; r < registers.end; ++r) {
            const std::uint32_t* const places = lists_.places().data() + r * N::count;
            for (std::size_t lane = 0; lane < N::count; ++lane)
                __builtin_prefetch(sums_.data() + places[lane + ahead] * stride);
            const auto along = [&](std::size_t axis) __attribute__((always_inline)) {
                return N::each([&](std::size_t lane) { return sums_[places[lane] * stride + axis]; });
            };
            sink(r, Vector<N>{along(0), along(1), along(2)});
        }
    }

    /// Adds to the sums of the slab, of its images and of the next slab.
    void add_pulls(const Slab& slab, Pulls& pulls) {
        place_images(slab);
        for (const Row& row : slab.rows) pulls.add(row, slab.list.data(), positions_.data(), sums_.data());
    }

    double cutoff_;
    double period_;
    double reach_;
    double allowed_;
    Periods<T> periods_;
    std::shared_ptr<Team> team_;  ///< shared with copies, which are never used at the same time
    ClusterLists<T> lists_{Pulls::group};
    std::vector<Pulls> pulls_;  ///< one for each member
    Field<T> made_at_;
    Numbers positions_, sums_;
};

}  // namespace steplab
