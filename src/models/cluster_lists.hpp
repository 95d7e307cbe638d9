#pragma once

#include "core/error.hpp"
#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/stages.hpp"
#include "core/vector.hpp"
#include "models/clusters.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace steplab {

/// For each cluster of four particles the others that at least one of them has within reach; together these lists hold
/// every such pair once. Particles are numbered by the clusters they are in; behind all clusters is one whose particles
/// are nowhere, and behind that one for each image of a cluster, a period away or more, that somebody may meet. T is
/// float or double.
template <class T>
class ClusterLists {
public:
    static constexpr std::uint32_t size = Clusters::size;
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

    /// Rows are filled up to whole groups of so many others.
    explicit ClusterLists(std::uint32_t group) : group_(group) {}

    /// Of particles that Clusters::make() takes. Throws UsageError if there are more pairs than can be numbered.
    void make(Field<double> positions, double reach, double period) {
        reach_ = reach;
        period_ = period;
        clusters_.make(positions, reach, period);
        gather_coordinates(std::exchange(positions, {}));
        list_.clear();
        rows_.clear();
        images_.clear();
        first_of_image_.assign(period > 0 ? clusters_.count() * Clusters::images : 0, 0);
        clusters_.each(
            [this](std::uint32_t cluster, std::span<const Clusters::Other> others) { append_row(cluster, others); });
        list_.insert(list_.end(), group_, nowhere());  // for who looks ahead
        coordinates_ = {};
        first_of_image_ = {};
    }

    std::span<const Row> rows() const { return rows_; }
    /// First numbers of particles; goes on for one group behind the last row.
    const std::uint32_t* list() const { return list_.data(); }
    /// Of each particle: the first of its numbers is this times `stride`.
    std::span<const std::uint32_t> places() const { return clusters_.places(); }
    std::span<const Image> images() const { return images_; }
    /// The first number of the first image.
    std::size_t first_image() const { return (clusters_.count() + 1) * numbers; }
    /// All numbers.
    std::size_t count() const { return first_image() + images_.size() * numbers; }

private:
    using Four = RegisterLanes<T, 4>;

    std::uint32_t nowhere() const { return static_cast<std::uint32_t>(clusters_.count() * numbers); }

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

    void append_row(std::uint32_t cluster, std::span<const Clusters::Other> others) {
        const std::size_t begin = list_.size(), most = begin + (others.size() + 2) * size;
        if (std::max(most, count()) > std::numeric_limits<std::uint32_t>::max())
            throw UsageError("the cut-off lets more pairs act than can be listed; choose a smaller one");
        // as long as the rows so far let expect: pages that are not reached cost nothing
        if (most > list_.capacity()) list_.reserve(most / (cluster + 1) * clusters_.count() + most);
        const auto own = static_cast<std::uint32_t>(cluster * numbers);
        list_.resize(most);
        for (std::uint32_t i = 0; i < size; ++i) list_[begin + i] = own + static_cast<std::uint32_t>(i * stride);
        std::size_t end = begin + size;
        for (const Clusters::Other other : others) end = append(cluster, other, end);
        for (; end % group_ > 0; ++end) list_[end] = nowhere();
        list_.resize(end);
        rows_.push_back({own, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
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

    /// The first number of another cluster, or of its image.
    std::uint32_t first_of(Clusters::Other other) {
        if (other.image() == Clusters::own_image) return static_cast<std::uint32_t>(other.cluster() * numbers);
        std::uint32_t& first = first_of_image_[other.cluster() * Clusters::images + other.image()];
        if (first == 0) {
            first = static_cast<std::uint32_t>(count());
            images_.push_back({other.cluster(), shift_of(other.image())});
        }
        return first;
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
    std::vector<std::uint32_t> list_;
    std::vector<Row> rows_;
    std::vector<Image> images_;
    // only while make() works
    std::vector<T> coordinates_;
    std::vector<std::uint32_t> first_of_image_;  ///< 0: that image of a cluster is not there
};

}  // namespace steplab
