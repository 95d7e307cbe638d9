#pragma once

#include "core/field.hpp"
#include "core/lanes.hpp"
#include "models/clusters.hpp"
#include "models/forces.hpp"
#include "models/morse_pair.hpp"
#include "models/periods.hpp"

#include <array>
#include <limits>
#include <vector>

namespace steplab {

/// The sums of NearPairForces in float and double: 4 x 4 pairs of particles at once, those of two clusters. The list of
/// pairs of clusters reaches a skin further than the forces, and is made anew when a particle has gone half the skin:
/// until then none can have come in. Every pair is computed once.
///
/// The order in which a particle's pulls are added hangs on the clusters, and these on where the particles were when
/// the list was made. So the last bits of an acceleration hang on that too: `made_at` is part of the state of a run. It
/// is kept and brought back with it, and whoever only looks does not renew it.
template <class T>
class ClusterPairs {
public:
    ClusterPairs(const NearPairForces& forces, const MorseConstants<T>& morse)
        : period_(forces.period),
          morse_{Block(morse.depth), Block(morse.b), Block(morse.r0), Block(morse.strength)},
          cutoff2_(static_cast<T>(forces.cutoff) * static_cast<T>(forces.cutoff)),
          reach_((1 + skin) * forces.cutoff),
          periods_(forces.period > 0 ? forces.period : 1) {
        const double allowed = most_moved * skin * forces.cutoff;
        allowed2_ = static_cast<T>(allowed * allowed);
        for (std::uint32_t image = 0; image < Clusters::images; ++image) {
            const auto along = [&](std::size_t axis) {
                return static_cast<T>(Clusters::periods(image, axis)) * static_cast<T>(forces.period);
            };
            shifts_[image] = {along(0), along(1), along(2)};
        }
    }

    /// True if the list holds all pairs nearer than the cut-off.
    bool holds_at(const Field<T>& u) const {
        if (made_at_.count() != u.count()) return false;
        const T *const x = u.x(), *const y = u.y(), *const z = u.z();
        const T *const x0 = made_at_.x(), *const y0 = made_at_.y(), *const z0 = made_at_.z();
        return !any_of_all(u.count(), [=, most = allowed2_](std::size_t i) {
            const T dx = x[i] - x0[i], dy = y[i] - y0[i], dz = z[i] - z0[i];
            return !(dx * dx + dy * dy + dz * dz <= most);
        });
    }

    /// Where the particles were when the list was made; empty before.
    const Field<T>& made_at() const { return made_at_; }
    /// Makes the list of these positions.
    void make_at(const Field<T>& u) {
        made_at_ = u;
        if (u.count() == 0) return;
        Field<double> placed(u.count());
        for (std::size_t i = 0; i < u.count(); ++i) {
            const Vector<T> p = in_period(u, i);
            placed.set(i, {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
        }
        clusters_.make(placed, reach_, period_);
        positions_.assign(clusters_.count() * stride, std::numeric_limits<T>::quiet_NaN());
        place(u);
        const Block most(static_cast<T>(reach_ * reach_));
        clusters_.keep_if([&](std::size_t cluster, Clusters::Other other) {
            const Vector<Block> d = rows(cluster, other.image()) - columns(other.cluster());
            return (d.x * d.x + d.y * d.y + d.z * d.z < most).anywhere();
        });
    }

    /// Of the list as it is.
    void accelerations(const Field<T>& u, Field<T>& a) {
        place(u);
        sums_.assign(positions_.size(), T(0));
        for (std::size_t cluster = 0; cluster < clusters_.count(); ++cluster) add_pulls(cluster);
        const auto places = clusters_.places();
        T *const x = a.x(), *const y = a.y(), *const z = a.z();
        for (std::size_t i = 0; i < places.size(); ++i) {
            const T* const sum = sums_.data() + number_of(places[i]);
            x[i] = sum[0];
            y[i] = sum[Clusters::size];
            z[i] = sum[2 * Clusters::size];
        }
    }

    /// Calls f(square of the distance) for all pairs nearer than the cut-off, where accelerations() was last asked for
    /// or the list was made.
    template <class F>
    void each_distance2(F f) const {
        for (std::size_t cluster = 0; cluster < clusters_.count(); ++cluster) {
            each_distance2(cluster, {static_cast<std::uint32_t>(cluster), Clusters::own_image}, f);
            for (const Clusters::Other other : clusters_.others(cluster)) each_distance2(cluster, other, f);
        }
    }

private:
    static constexpr std::size_t size = Clusters::size;
    using Four = RegisterLanes<T, size>;
    using Block = RegisterLanes<T, size * size>;  ///< pairs: lane 4 i + j is that of i with j
    using Numbers = std::vector<T, CacheLineAllocator<T>>;

    /// Parts of the cut-off.
    static constexpr double skin = 0.15;
    /// Part of the skin that a particle may go: half of it, less what rounding may hide.
    static constexpr double most_moved = 0.48;

    /// Numbers of a cluster: four x, four y, four z.
    static constexpr std::size_t stride = 3 * size;
    static std::size_t number_of(std::uint32_t place) { return place / size * stride + place % size; }

    Vector<T> in_period(const Field<T>& u, std::size_t i) const {
        const auto within = [&](const T* along, const T* made_at) {
            return period_ > 0 ? along[i] - periods_.nearest(made_at[i]) : along[i];
        };
        return {within(u.x(), made_at_.x()), within(u.y(), made_at_.y()), within(u.z(), made_at_.z())};
    }

    /// Each particle where its cluster is; places of no particle stay nowhere, out of everybody's reach.
    void place(const Field<T>& u) {
        const auto places = clusters_.places();
        for (std::size_t i = 0; i < places.size(); ++i) {
            T* const to = positions_.data() + number_of(places[i]);
            const Vector<T> p = in_period(u, i);
            to[0] = p.x;
            to[size] = p.y;
            to[2 * size] = p.z;
        }
    }

    /// The particles i of a cluster as seen from an image of space.
    [[gnu::always_inline]] Vector<Block> rows(std::size_t cluster, std::uint32_t image) const {
        const T* const from = positions_.data() + cluster * stride;
        const auto along = [from](std::size_t axis, T shift) {
            return Block::each([=](std::size_t lane) { return from[axis * size + lane / size] - shift; });
        };
        const Vector<T>& shift = shifts_[image];
        return {along(0, shift.x), along(1, shift.y), along(2, shift.z)};
    }
    /// The particles j.
    [[gnu::always_inline]] Vector<Block> columns(std::size_t cluster) const {
        const T* const from = positions_.data() + cluster * stride;
        const auto along = [from](std::size_t axis) {
            return Block::repeated(Four::load_anywhere(from + axis * size));
        };
        return {along(0), along(1), along(2)};
    }

    /// The pulls of j at i.
    [[gnu::always_inline]] Vector<Block> pulls(const Vector<Block>& rows, std::size_t cluster) const {
        const Vector<Block> d = rows - columns(cluster);
        const auto near = d.x * d.x + d.y * d.y + d.z * d.z < Block(cutoff2_);
        const Vector<Block> pull = morse_pull(morse_, d);
        const Block zero(T(0));
        return {where(near, pull.x, zero), where(near, pull.y, zero), where(near, pull.z, zero)};
    }

    template <class F>
    void each_distance2(std::size_t cluster, Clusters::Other other, F f) const {
        const Vector<Block> d = rows(cluster, other.image()) - columns(other.cluster());
        alignas(64) std::array<T, size * size> distances2;
        (d.x * d.x + d.y * d.y + d.z * d.z).store(distances2.data());
        const bool itself = cluster == other.cluster() && other.image() == Clusters::own_image;
        for (std::size_t pair = 0; pair < size * size; ++pair) {
            const bool once = !itself || pair % size > pair / size;
            if (once && distances2[pair] < cutoff2_) f(distances2[pair]);
        }
    }

    /// Of all pairs of this cluster with those listed.
    void add_pulls(std::size_t cluster) {
        std::uint32_t image = Clusters::own_image;
        Vector<Block> at = rows(cluster, image);
        Vector<Block> sum = once_each(pulls(at, cluster));
        add_opposite(cluster, sum);
        for (const Clusters::Other other : clusters_.others(cluster)) {
            if (other.image() != image) at = rows(cluster, image = other.image());
            const Vector<Block> pull = pulls(at, other.cluster());
            sum = sum + pull;
            add_opposite(other.cluster(), pull);
        }
        add_rows(cluster, sum);
    }

    /// Of the pairs of a cluster with itself those with i < j.
    [[gnu::always_inline]] static Vector<Block> once_each(const Vector<Block>& pull) {
        const Block zero(T(0)), behind = Block::each([](std::size_t lane) {
            return lane % size > lane / size ? T(1) : T(0);
        });
        const auto once = behind > zero;
        return {where(once, pull.x, zero), where(once, pull.y, zero), where(once, pull.z, zero)};
    }

    /// What the particles i do to the particles j: (0 + 2) + (1 + 3).
    [[gnu::always_inline]] void add_opposite(std::size_t cluster, const Vector<Block>& pull) {
        T* const to = sums_.data() + cluster * stride;
        const auto along = [to](std::size_t axis, const Block& pulls) {
            const Four sum = Four::load_anywhere(to + axis * size) - pulls.halves_added().halves_added();
            sum.store_anywhere(to + axis * size);
        };
        along(0, pull.x);
        along(1, pull.y);
        along(2, pull.z);
    }

    /// What the particles j do to the particles i: (0 + 2) + (1 + 3).
    [[gnu::always_inline]] void add_rows(std::size_t cluster, const Vector<Block>& pull) {
        T* const to = sums_.data() + cluster * stride;
        const auto along = [to](std::size_t axis, const Block& pulls) {
            alignas(64) std::array<T, size * size> of;
            pulls.store(of.data());
            for (std::size_t i = 0; i < size; ++i) {
                const T* const row = of.data() + i * size;
                to[axis * size + i] += (row[0] + row[2]) + (row[1] + row[3]);
            }
        };
        along(0, pull.x);
        along(1, pull.y);
        along(2, pull.z);
    }

    double period_;
    MorseConstants<Block> morse_;
    T cutoff2_;
    T allowed2_;
    double reach_;
    Periods<T> periods_;
    std::array<Vector<T>, Clusters::images> shifts_;
    Clusters clusters_;
    Field<T> made_at_;
    Numbers positions_, sums_;
};

}  // namespace steplab
