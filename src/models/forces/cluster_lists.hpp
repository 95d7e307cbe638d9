#pragma once

#include "core/compressed_lanes.hpp"
#include "core/error.hpp"
#include "core/field.hpp"
#include "core/lane_vectors.hpp"
#include "core/lanes.hpp"
#include "core/team.hpp"
#include "core/vector.hpp"
#include "models/forces/cluster_pairs.hpp"
#include "models/forces/clusters.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace steplab {

/// For each cluster of four particles the others that at least one of them has within reach; together these lists hold
/// every such pair once. Particles are numbered by the clusters they are in; behind all clusters is, for each slab, one
/// whose particles are nowhere, and behind these, slab by slab, one for each image of a cluster, a period away or more,
/// that somebody of the slab may meet. T is float or double.
template <class T>
class ClusterLists {
public:
    static constexpr std::uint32_t size = Clusters::size;
    /// So far behind its end somebody may look who goes through a list.
    static constexpr std::uint32_t spare = 128;
    /// Numbers of a particle: x, y, z and one that means nothing; and of a cluster.
    static constexpr std::size_t stride = 4, numbers = size * stride;

    /// A cluster and its part of the list: its own particles and then the others.
    struct Row {
        std::uint32_t own;         ///< the first of its numbers
        std::uint32_t begin, end;  ///< of the first numbers of the others, in the list
    };
    struct Image {
        std::uint32_t cluster;
        Vector<T> shift;
    };

    /// What the clusters of a slab need.
    struct Slab {
        std::vector<Row> rows;
        std::vector<std::uint32_t> list;  ///< first numbers of particles; `spare` more than the rows have
        std::vector<Image> images;
        std::size_t first_image = 0;  ///< the first number of the first of them
        std::uint32_t nowhere = 0;    ///< the first number of a particle that is nowhere
    };

    /// Rows are filled up to whole groups of so many others.
    explicit ClusterLists(std::uint32_t group) : group_(group) {}

    /// Of particles that Clusters::make() takes. Throws UsageError if there are more pairs than can be numbered.
    void make(std::size_t particles, const Clusters::Position& position, double reach, double period, Team& team) {
        reach_ = reach;
        period_ = period;
        clusters_.make(particles, position, reach, period, team);
        if (clusters_.count() > Clusters::most) refuse();
        gather_coordinates(particles, position, team);
        slabs_.resize(clusters_.slabs().size());
        team.share(slabs_.size(), [this](std::size_t i) { make(i); });
        Numbers().swap(coordinates_);
        count_ = first_image();
        for (Slab& slab : slabs_) {
            slab.first_image = count_;
            count_ += slab.images.size() * numbers;
        }
        if (count_ > most) refuse();
        team.share(slabs_.size(), [this](std::size_t i) { number_images(slabs_[i]); });
        longest_ = 0;
        for (const Slab& slab : slabs_) {
            for (const Row& row : slab.rows) longest_ = std::max<std::size_t>(longest_, row.end - row.begin);
        }
    }

    std::span<const Slab> slabs() const { return slabs_; }
    /// Of each particle, and then some of nobody (Clusters::places()): the first of its numbers is this times `stride`.
    std::span<const std::uint32_t> places() const { return clusters_.places(); }
    /// Others in a row, at most.
    std::size_t longest() const { return longest_; }
    std::size_t clusters() const { return clusters_.count(); }
    /// All numbers.
    std::size_t count() const { return count_; }

private:
    using N = CacheLineLanes<T>;
    using Numbers = std::vector<T, CacheLineAllocator<T>>;

    /// Places of images among those of a slab, plus one; 0 where an image has none. Of clusters from `first` on.
    struct Places {
        std::uint32_t first;
        std::vector<std::uint32_t> of_image;
    };

    static constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();

    [[noreturn]] static void refuse() {
        throw UsageError("the cut-off lets more pairs act than can be listed; choose a smaller one");
    }

    /// Numbers of particles that are nowhere: each slab adds to its own.
    std::uint32_t nowhere(std::size_t slab) const {
        return static_cast<std::uint32_t>((clusters_.count() + slab) * numbers);
    }
    std::uint32_t first_image() const { return nowhere(slabs_.size()); }

    /// Of every cluster x of its particles, then y, then z.
    void gather_coordinates(std::size_t particles, const Clusters::Position& position, Team& team) {
        coordinates_.assign(clusters_.count() * 3 * size, std::numeric_limits<T>::quiet_NaN());
        team.run([&](std::size_t member) {
            const auto [begin, end] = team.part(particles, member);
            for (std::size_t i = begin; i < end; ++i) {
                const Vec3 p = position(i);
                const std::uint32_t place = clusters_.places()[i];
                T* const to = coordinates_.data() + place / size * 3 * size + place % size;
                to[0] = static_cast<T>(p.x);
                to[size] = static_cast<T>(p.y);
                to[2 * size] = static_cast<T>(p.z);
            }
        });
    }

    /// Its images are numbered as if there were no other slab.
    void make(std::size_t i) {
        const std::span<const Clusters::Slab> all = clusters_.slabs();
        Slab slab = std::move(slabs_[i]);
        slab.rows.clear();
        slab.list.clear();
        slab.images.clear();
        slab.nowhere = nowhere(i);
        Places places{all[i].begin, {}};
        const std::size_t end = i == 0 ? clusters_.count() : all[std::min(i + 1, all.size() - 1)].end;
        if (period_ > 0) places.of_image.resize((end - places.first) * Clusters::images);
        ClusterPairs(clusters_).each(all[i], [&, rows = all[i].end - all[i].begin](std::uint32_t cluster, auto others) {
            make_room((others.size() + 2) * size, rows, slab);
            append_row(cluster, others, slab, places);
        });
        slab.list.insert(slab.list.end(), spare, slab.nowhere);
        slabs_[i] = std::move(slab);
    }

    /// For so many more in the list: as many as the rows so far let expect, as pages that are not reached cost nothing.
    static void make_room(std::size_t more, std::size_t rows, Slab& slab) {
        const std::size_t room = slab.list.size() + more;
        if (std::max(room, slab.images.size() * numbers) > most) refuse();
        if (room > slab.list.capacity()) slab.list.reserve(room / (slab.rows.size() + 1) * rows + room);
    }

    void append_row(std::uint32_t cluster, std::span<const Clusters::Other> others, Slab& slab, Places& places) const {
        std::vector<std::uint32_t>& list = slab.list;
        const std::size_t begin = list.size();
        const auto own = static_cast<std::uint32_t>(cluster * numbers);
        list.resize(begin + (others.size() + 2) * size);
        for (std::uint32_t i = 0; i < size; ++i) list[begin + i] = own + static_cast<std::uint32_t>(i * stride);
        std::size_t end = begin + size;
        const FourByFour particles = four_by_four(cluster);
        for (const Clusters::Other other : others) {
            const LaneSet near = within_reach(particles, other);
            if (other.image() != Clusters::own_image && near == 0) continue;
            const std::uint32_t first = first_of(other, slab, places);
            for (std::size_t j = 0; j < size; ++j) {
                list[end] = first + static_cast<std::uint32_t>(j * stride);
                end += near >> j & 1;
            }
        }
        for (; end % group_ > 0; ++end) list[end] = slab.nowhere;
        list.resize(end);
        slab.rows.push_back({own, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
    }

    /// The particles of a cluster, each four times, in as many registers as there are numbers for.
    using FourByFour = std::array<Vector<N>, size * size / N::count>;
    FourByFour four_by_four(std::uint32_t cluster) const {
        const T* const from = coordinates_.data() + cluster * 3 * size;
        FourByFour result;
        for (std::size_t k = 0; k < result.size(); ++k) {
            const auto along = [&](const T* four) {
                return N::each([=](std::size_t lane) { return four[(k * N::count + lane) / size]; });
            };
            result[k] = {along(from), along(from + size), along(from + 2 * size)};
        }
        return result;
    }

    /// Which particles of another cluster are within reach of a particle of this one.
    LaneSet within_reach(const FourByFour& own, Clusters::Other other) const {
        const Vector<T> image = shift_of(other.image());
        const T* const from = coordinates_.data() + other.cluster() * 3 * size;
        const auto along = [=](std::size_t axis) { return repeated_four<T, N::count>(from + axis * size); };
        const Vector<N> them{along(0), along(1), along(2)};
        const N reach2(static_cast<T>(reach_ * reach_));
        LaneSet near = 0;
        for (const Vector<N>& some : own) {
            const Vector<N> d = some - Vector<N>{N(image.x), N(image.y), N(image.z)} - them;
            near |= lanes_below(d.x * d.x + d.y * d.y + d.z * d.z, reach2);
        }
        for (std::size_t half = N::count / 2; half >= size; half /= 2) near |= near >> half;
        return near & first_lanes(size);
    }

    /// The first number of another cluster, or of its image.
    std::uint32_t first_of(Clusters::Other other, Slab& slab, Places& places) const {
        if (other.image() == Clusters::own_image) return static_cast<std::uint32_t>(other.cluster() * numbers);
        std::uint32_t& place = places.of_image[(other.cluster() - places.first) * Clusters::images + other.image()];
        if (place == 0) {
            slab.images.push_back({other.cluster(), shift_of(other.image())});
            place = static_cast<std::uint32_t>(slab.images.size());
        }
        return first_image() + static_cast<std::uint32_t>((place - 1) * numbers);
    }

    /// Behind those of the slabs before.
    void number_images(Slab& slab) const {
        const std::uint32_t first = first_image(), before = static_cast<std::uint32_t>(slab.first_image) - first;
        if (before == 0) return;
        for (std::uint32_t& number : slab.list) number += number >= first ? before : 0;
    }

    Vector<T> shift_of(std::uint32_t image) const {
        if (image == Clusters::own_image) return {T(0), T(0), T(0)};
        const auto shift = [&](std::size_t axis) {
            return static_cast<T>(Clusters::periods(image, axis)) * static_cast<T>(period_);
        };
        return {shift(0), shift(1), shift(2)};
    }

    std::uint32_t group_;
    double reach_ = 0, period_ = 0;
    Clusters clusters_;
    std::vector<Slab> slabs_;
    std::size_t count_ = 0, longest_ = 0;
    Numbers coordinates_;  ///< only while make() works
};

}  // namespace steplab
