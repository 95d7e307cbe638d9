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

/// The sums of NearPairForces in float and double. Each cluster of four particles has a list of others that at least
/// one of them may meet; together they hold every pair once, and they reach a skin further than the forces: a list is
/// made anew when a particle has gone half the skin, until then no pair can have come in. A list is gone through as
/// many pairs at a time as a cache line has numbers, on every machine: four particles side by side with two others
/// (float: four). Particles are numbered by the clusters they are in, so that those near in space are near in memory.
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
        clusters_.make(within, reach_, period_);
        gather_coordinates(within);
        make_lists();
        positions_.assign((clusters_.count() + 1 + images_.size()) * numbers, std::numeric_limits<T>::quiet_NaN());
        place(u);
    }

    /// Of the lists as they are.
    void accelerations(const Field<T>& u, Field<T>& a) {
        place(u);
        sums_.assign(positions_.size(), T(0));
        for (const Row& row : rows_) add_pulls(row);
        add_up_images();
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
            each_part(row, [&](const Distances& pairs, std::uint32_t, std::uint32_t) {
                for (std::size_t lane = 0; lane < N::count; ++lane) {
                    if (pairs.square[lane] < cutoff2_) f(pairs.square[lane]);
                }
            });
        }
    }

private:
    /// Of four particles and at least one other.
    using N = RegisterLanes<T, std::max<std::size_t>(detail::register_bytes / sizeof(T), 4)>;
    using Four = RegisterLanes<T, 4>;
    using Numbers = std::vector<T, CacheLineAllocator<T>>;

    static constexpr std::uint32_t size = Clusters::size;
    /// Others of a group, on every machine, and those of them that go side by side.
    static constexpr std::uint32_t group = CacheLineLanes<T>::count / size, at_once = N::count / size;
    /// Of the parts of a group.
    using Sums = std::array<Vector<N>, group / at_once>;
    /// Numbers of a particle: x, y, z and one that means nothing; and of a cluster.
    static constexpr std::size_t stride = 4, numbers = size * stride;

    /// A cluster and its part of the list: its own particles and then the others.
    struct Row {
        std::uint32_t own;         ///< the first of its numbers
        std::uint32_t begin, end;  ///< of the first numbers of the others, in the list
    };
    /// A cluster one period away or more, numbered as if it were one of the others.
    struct Image {
        std::uint32_t cluster, image;
    };

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

    /// Places of no particle, and those of a cluster behind all others, stay nowhere: out of everybody's reach. Behind
    /// that are the images.
    void place(const Field<T>& u) {
        const auto places = clusters_.places();
        for (std::size_t i = 0; i < places.size(); ++i) {
            T* const to = positions_.data() + places[i] * stride;
            const Vector<T> p = in_period(u, i);
            to[0] = p.x;
            to[1] = p.y;
            to[2] = p.z;
        }
        T* to = first_image(positions_);
        for (const Image& image : images_) {
            const Vector<T> shift = shift_of(image.image);
            const Four by = Four::each([&](std::size_t axis) {
                return axis == 0 ? shift.x : axis == 1 ? shift.y : shift.z;
            });
            const T* const from = positions_.data() + image.cluster * numbers;
            for (std::size_t k = 0; k < numbers; k += stride) (Four::load(from + k) + by).store(to + k);
            to += numbers;
        }
    }

    /// What pulls at an image pulls at its particle.
    void add_up_images() {
        const T* from = first_image(sums_);
        for (const Image& image : images_) {
            T* const to = sums_.data() + image.cluster * numbers;
            for (std::size_t k = 0; k < numbers; k += stride) (Four::load(to + k) + Four::load(from + k)).store(to + k);
            from += numbers;
        }
    }

    T* first_image(Numbers& of) const { return of.data() + (clusters_.count() + 1) * numbers; }

    Vector<T> shift_of(std::uint32_t image) const {
        if (image == Clusters::own_image) return {T(0), T(0), T(0)};
        const auto shift = [&](std::size_t axis) {
            return static_cast<T>(Clusters::periods(image, axis)) * static_cast<T>(period_);
        };
        return {shift(0), shift(1), shift(2)};
    }

    /// Of every cluster x of its particles, then y, then z.
    void gather_coordinates(const Field<double>& positions) {
        coordinates_.assign(clusters_.count() * 3 * size, std::numeric_limits<T>::quiet_NaN());
        for (std::size_t i = 0; i < positions.count(); ++i) {
            const std::uint32_t place = clusters_.places()[i];
            T* const to = coordinates_.data() + place / size * 3 * size + place % size;
            to[0] = static_cast<T>(positions.x()[i]);
            to[size] = static_cast<T>(positions.y()[i]);
            to[2 * size] = static_cast<T>(positions.z()[i]);
        }
    }

    void make_lists() {
        rows_.clear();
        list_.clear();
        images_.clear();
        first_of_image_.assign(period_ > 0 ? clusters_.count() * Clusters::images : 0, 0);
        const auto nowhere = static_cast<std::uint32_t>(clusters_.count() * numbers);
        for (std::uint32_t cluster = 0; cluster < clusters_.count(); ++cluster) {
            const auto others = clusters_.others(cluster);
            const std::size_t begin = list_.size();
            const auto own = static_cast<std::uint32_t>(cluster * numbers);
            list_.resize(begin + (others.size() + 2) * size);
            for (std::uint32_t i = 0; i < size; ++i) list_[begin + i] = own + static_cast<std::uint32_t>(i * stride);
            std::size_t end = begin + size;
            for (const Clusters::Other other : others) end = append(cluster, other, end);
            for (; end % group > 0; ++end) list_[end] = nowhere;
            list_.resize(end);
            rows_.push_back({own, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
        }
        list_.insert(list_.end(), group, nowhere);  // for who looks ahead
    }

    /// The first number of another cluster, where it is one period away or more of that image.
    std::uint32_t first_of(Clusters::Other other) {
        if (other.image() == Clusters::own_image) return static_cast<std::uint32_t>(other.cluster() * numbers);
        std::uint32_t& first = first_of_image_[other.cluster() * Clusters::images + other.image()];
        if (first == 0) {
            first = static_cast<std::uint32_t>((clusters_.count() + 1 + images_.size()) * numbers);
            images_.push_back({other.cluster(), other.image()});
        }
        return first;
    }

    /// To the list from `end` on, those of another cluster that are within reach of a particle of this one. Returns its
    /// new end.
    std::size_t append(std::uint32_t cluster, Clusters::Other other, std::size_t end) {
        const Vector<T> image = shift_of(other.image());
        const T* const own = coordinates_.data() + cluster * 3 * size;
        const T* const them = coordinates_.data() + other.cluster() * 3 * size;
        const Four x = Four::load_anywhere(them), y = Four::load_anywhere(them + size),
                   z = Four::load_anywhere(them + 2 * size);
        Four nearest(std::numeric_limits<T>::infinity());
        for (std::size_t i = 0; i < size; ++i) {
            const Four dx = Four(own[i] - image.x) - x, dy = Four(own[i + size] - image.y) - y,
                       dz = Four(own[i + 2 * size] - image.z) - z;
            const Four square = dx * dx + dy * dy + dz * dz;
            nearest = where(square < nearest, square, nearest);
        }
        const auto near = nearest < Four(static_cast<T>(reach_ * reach_));
        if (other.image() != Clusters::own_image && !any(near, size)) return end;
        const std::uint32_t first = first_of(other);
        for (std::size_t j = 0; j < size; ++j) {
            list_[end] = first + static_cast<std::uint32_t>(j * stride);
            end += near[j] != 0 ? 1 : 0;
        }
        return end;
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
        const std::uint32_t* const others = list_.data() + k;
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
            row, [&, list = list_.data() ](const Distances& pairs, std::uint32_t k, std::uint32_t part)
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
    Clusters clusters_;
    Field<T> made_at_;
    Numbers positions_, sums_;
    std::vector<Row> rows_;
    std::vector<std::uint32_t> list_;
    std::vector<Image> images_;
    // memory of make_lists()
    Numbers coordinates_;
    std::vector<std::uint32_t> first_of_image_;  ///< 0: that image of a cluster is not there
};

}  // namespace steplab
