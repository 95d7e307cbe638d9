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

/// For each cluster of four particles, the other particles within reach of at least one of them; together these lists
/// hold every such pair once. Particles are numbered by cluster. After all clusters there is one cluster of padding
/// particles for each slab, and after these, slab by slab, one for each periodic image of a cluster that particles of
/// the slab may interact with. T is float or double.
template <class T>
class ClusterLists {
public:
    static constexpr std::uint32_t size = Clusters::size;
    /// Number of elements that may be read beyond the end of a list.
    static constexpr std::uint32_t spare = 128;
    /// Numbers stored for a particle (x, y, z and an unused one) and for a cluster.
    static constexpr std::size_t stride = 4, numbers = size * stride;

    /// A cluster and its part of the list: its own particles and then the others.
    struct Row {
        std::uint32_t own;         ///< index of its first number
        std::uint32_t begin, end;  ///< of its other particles, in the list
    };
    struct Image {
        std::uint32_t cluster;
        Vector<T> shift;
    };

    /// The lists of the clusters of a slab.
    struct Slab {
        std::vector<Row> rows;
        std::vector<std::uint32_t> list;  ///< indices of the first numbers of particles; `spare` more than in the rows
        std::vector<Image> images;
        std::size_t first_image = 0;  ///< index of the first number of the first image
        std::uint32_t nowhere = 0;    ///< index of the first number of a padding particle
    };

    /// Rows are padded to a multiple of `group` particles.
    explicit ClusterLists(std::uint32_t group) : group_(group) {}

    /// Makes the lists; parameters as for Clusters::make(). Throws UsageError if there are more pairs than can be
    /// numbered.
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
    /// The place of each particle, then some padding (Clusters::places()): its first number has the index place *
    /// `stride`.
    std::span<const std::uint32_t> places() const { return clusters_.places(); }
    /// Length of the longest row.
    std::size_t longest() const { return longest_; }
    std::size_t clusters() const { return clusters_.count(); }
    /// Total number of numbers.
    std::size_t count() const { return count_; }

private:
    using N = CacheLineLanes<T>;
    using Numbers = std::vector<T, CacheLineAllocator<T>>;

    /// Positions of the images of clusters, from cluster `first`, in a slab's list of images, plus one; 0 if an image
    /// is not there.
    struct Places {
        std::uint32_t first;
        std::vector<std::uint32_t> of_image;
    };

    static constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();

    [[noreturn]] static void refuse() {
        throw UsageError("there are more pairs within the cut-off than can be listed; choose a smaller cutoff");
    }

    /// Index of the padding particles: each slab adds to its own.
    std::uint32_t nowhere(std::size_t slab) const {
        return static_cast<std::uint32_t>((clusters_.count() + slab) * numbers);
    }
    std::uint32_t first_image() const { return nowhere(slabs_.size()); }

    /// For every cluster x of its particles, then y, then z.
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

    /// Images are numbered as if this were the only slab.
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

    /// Reserves room for the expected length of the list, from the rows so far; memory pages that are not reached cost
    /// nothing.
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

    /// The particles of a cluster, each four times, in as many registers as needed.
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

    /// The particles of another cluster within reach of any particle of this one.
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

    /// Index of the first number of another cluster, or of its image.
    std::uint32_t first_of(Clusters::Other other, Slab& slab, Places& places) const {
        if (other.image() == Clusters::own_image) return static_cast<std::uint32_t>(other.cluster() * numbers);
        std::uint32_t& place = places.of_image[(other.cluster() - places.first) * Clusters::images + other.image()];
        if (place == 0) {
            slab.images.push_back({other.cluster(), shift_of(other.image())});
            place = static_cast<std::uint32_t>(slab.images.size());
        }
        return first_image() + static_cast<std::uint32_t>((place - 1) * numbers);
    }

    /// Numbers the images after those of the previous slabs.
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
    Numbers coordinates_;  ///< only during make()
};

}  // namespace steplab
